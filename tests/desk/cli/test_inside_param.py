"""`ros2 param ...` in the simulation."""

from __future__ import annotations

import pytest


def test_list_of_one_node_and_of_all(machine) -> None:
    names = machine.read('ros2 param list sim')
    assert names.startswith('  background_b\n  background_g\n  background_r\n  holonomic\n')
    assert machine.read('ros2 param list') == f'/sim:\n{names}'


def test_list_with_types_filter_and_prefix(machine) -> None:
    assert machine.read('ros2 param list /sim --param-type --filter background_[rg]') == (
        '  background_g (type: integer)\n  background_r (type: integer)\n'
    )
    assert machine.read('ros2 param list /sim --param-prefixes holonomic') == '  holonomic\n'


@pytest.mark.parametrize(
    ('words', 'answer'),
    [
        ('background_g', 'Integer value is: 86\n'),
        ('holonomic', 'Boolean value is: False\n'),
        ('background_b --hide-type', '255\n'),
    ],
)
def test_get(machine, words: str, answer: str) -> None:
    assert machine.read(f'ros2 param get /sim {words}') == answer


def test_get_of_an_unknown_parameter(machine) -> None:
    assert machine.fails('ros2 param get /sim backgroundr') == "Parameter not set\n  help: did you mean 'background_r'?\n"


def test_set_changes_the_node(machine) -> None:
    assert machine.read('ros2 param set sim background_r 150') == 'Set parameter successful\n'
    assert machine.read('ros2 param get sim background_r') == 'Integer value is: 150\n'


@pytest.mark.parametrize(
    ('words', 'complaint'),
    [
        ('background_r 1.5', 'help: write the number without a point'),
        ('backgroundr 1', "help: did you mean 'background_r'?"),
        ('background_r 300', 'range'),
    ],
)
def test_a_refused_value_is_said_and_the_status_is_0_as_in_ros(machine, words: str, complaint: str) -> None:
    typed = machine.run(f'ros2 param set /sim {words}')
    assert (typed.code, typed.out) == (0, '')
    assert typed.err.startswith('Setting parameter failed: ') and complaint in typed.err


def test_describe(machine) -> None:
    assert machine.read('ros2 param describe sim background_r') == (
        'Parameter name: background_r\n  Type: integer\n  Description: Red channel of the background color\n'
        '  Constraints:\n    Min value: 0\n    Max value: 255\n    Step: 1\n'
    )


def test_dump_can_be_loaded_again(machine) -> None:
    text = machine.read('ros2 param dump sim')
    assert text.startswith('/sim:\n  ros__parameters:\n    background_b: 255\n') and text.endswith('use_sim_time: false\n\n')
    (machine.folder / 'sim.yaml').write_text(text.replace('background_b: 255', 'background_b: 1'))
    typed = machine.run('ros2 param load sim sim.yaml')
    assert 'Set parameter background_b successful\n' in typed.out
    assert 'Set parameter qos_overrides./parameter_events.publisher.depth failed: ' in typed.err
    assert machine.read('ros2 param get sim background_b') == 'Integer value is: 1\n'


def test_load_of_a_missing_file(machine) -> None:
    assert machine.fails('ros2 param load sim no.yaml').startswith("[Errno 2] No such file or directory: 'no.yaml'\n")


def test_delete_takes_undeclared_parameters_only(machine) -> None:
    machine.start('ros2 run demo_nodes_cpp parameter_blackboard')
    machine.session.run(0.1)
    machine.read('ros2 param set parameter_blackboard speed 3.45')
    assert machine.read('ros2 param get parameter_blackboard speed') == 'Double value is: 3.45\n'
    assert machine.read('ros2 param delete parameter_blackboard speed') == 'Deleted parameter successfully\n'
    assert machine.read('ros2 param get parameter_blackboard speed') == 'Parameter not set.\n'


def test_a_typed_parameter_of_a_cpp_node_cannot_be_deleted(machine) -> None:
    typed = machine.run('ros2 param delete sim background_r')
    assert (typed.code, typed.err) == (0, 'Deleting parameter failed: cannot undeclare a statically typed parameter\n')
    assert machine.read('ros2 param get sim background_r') == 'Integer value is: 69\n'


def test_an_unknown_node_is_waited_for_one_second(machine) -> None:
    typed = machine.run('ros2 param get /simm background_r', 1.5)
    assert typed.writes == [(2.0, "Node not found\n  help: did you mean '/sim'?\n")] and typed.code == 1


def test_a_value_that_is_no_yaml_is_refused_with_help(machine) -> None:
    said = machine.fails('ros2 param set /sim background_r @home')
    assert "found character '@' that cannot start any token" in said
    assert said.endswith("""help: for a string, use two kinds of quotation marks: '"@home"'\n""")


def test_a_date_that_does_not_exist_is_refused_with_help(machine) -> None:
    assert machine.fails('ros2 param set /sim background_r 2020-99-99').startswith('month must be in 1..12\n  help: ')


def test_dump_into_a_folder_can_be_loaded_again(machine) -> None:
    said = machine.read('ros2 param dump /sim --output-dir .')
    assert said == f'Saving to:  {machine.folder}/./sim.yaml\n'
    assert 'Set parameter background_b successful' in machine.run('ros2 param load /sim sim.yaml', 1.0).out
    assert machine.fails('ros2 param dump /sim --output-dir nowhere').startswith("'nowhere' is not a valid directory.")


NEVER_SPINS = """import time
import rclpy
from rclpy.node import Node
rclpy.init()
node = Node('idle')
while True:
    time.sleep(0.5)
"""
SILENT = '/idle has not answered for {} s: it may not spin, a callback may take long, or it may not have this service\n'


def test_a_node_that_never_spins_costs_a_second_and_the_others_are_listed(machine) -> None:
    (machine.folder / 'idle.py').write_text(NEVER_SPINS)
    machine.run('python3 idle.py')
    listed = machine.run('ros2 param list', 3.0)
    assert listed.code == 0 and listed.out.startswith('/sim:\n  background_b\n') and listed.err == SILENT.format(1)
    begun = machine.now()
    for line in ('get /idle use_sim_time', 'dump /idle'):
        typed = machine.run(f'ros2 param {line}', 12.0)
        assert typed.code == 1 and typed.err == f'note: {SILENT.format(1)[:-1]}; waiting for 9 s more\n{SILENT.format(10)}', (
            typed.err
        )
        assert [round(at - begun) for at, _ in typed.writes] == [1, 10]
        begun = machine.now()

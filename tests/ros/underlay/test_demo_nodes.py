"""The demo programs' log lines and timing (facts_tutorials.md, section E)."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.srv import GetParameters
from std_msgs.msg import String


@pytest.mark.parametrize(
    'package, texts',
    [
        ('demo_nodes_cpp', ["Publishing: 'Hello World: 1'", "Publishing: 'Hello World: 2'"]),
        ('demo_nodes_py', ['Publishing: "Hello World: 0"', 'Publishing: "Hello World: 1"']),
    ],
)
def test_talker_greets_every_second(stage: Any, package: str, texts: list[str]) -> None:
    stage.start(package, 'talker')
    stage.until(2500)
    assert stage.tape.logs == [(1000.0, texts[0]), (2000.0, texts[1])]


@pytest.mark.parametrize(('package', 'says'), [('demo_nodes_cpp', 2), ('demo_nodes_py', 0)])
def test_a_wall_timer_also_fires_while_nobody_publishes_clock(stage: Any, package: str, says: int) -> None:
    stage.start(package, 'talker', '--ros-args', '-p', 'use_sim_time:=true')
    stage.until(2500)
    assert len(stage.tape.logs) == says


@pytest.mark.parametrize(
    'package, executable',
    [('demo_nodes_cpp', 'listener'), ('demo_nodes_cpp', 'listener_best_effort'), ('demo_nodes_py', 'listener')],
)
def test_listener_says_what_it_heard(stage: Any, package: str, executable: str) -> None:
    stage.start(package, executable)
    stage.until(100)
    stage.publish('/chatter', String(data='hello'))
    stage.until(200)
    assert stage.tape.logs == [(100.0, 'I heard: [hello]')]


def test_names_are_remapped(stage: Any) -> None:
    stage.start(
        'demo_nodes_cpp', 'talker', '--ros-args', '-r', '__ns:=/demo', '-r', '__node:=my_talker', '-r', 'chatter:=my_topic'
    )
    stage.until(1100)
    assert stage.messages('/demo/my_topic') == [String(data='Hello World: 1')]


@pytest.mark.parametrize('package', ['demo_nodes_cpp', 'demo_nodes_py'])
@pytest.mark.parametrize('client', ['add_two_ints_client', 'add_two_ints_client_async'])
def test_client_waits_for_the_server_then_gets_its_sum(stage: Any, package: str, client: str) -> None:
    asking = stage.start(package, client)
    stage.until(1200)
    stage.start(package, 'add_two_ints_server')
    stage.until(4000)
    said = stage.texts() + [text.strip() for _, text in stage.tape.outputs]
    assert 'service not available, waiting again...' in said
    assert stage.texts()[-2:] == ['Incoming request\na: 2 b: 3', 'Result of add_two_ints: 5']
    assert asking.returncode == 0


def test_blackboard_counts_and_keeps_what_it_is_given(stage: Any) -> None:
    stage.start('demo_nodes_cpp', 'parameter_blackboard', '--ros-args', '-p', 'some_int:=42', '-p', 'a_string:=Hello world')
    stage.until(10)
    [text] = stage.texts()
    assert text == ("Parameter blackboard node named '/parameter_blackboard' ready, and serving '8' parameters already!")
    replies = stage.ask('/parameter_blackboard/get_parameters', GetParameters, names=['some_int'])
    stage.until(20)
    assert replies[0].values[0].integer_value == 42


def test_async_param_client_works_on_the_blackboard(stage: Any) -> None:
    stage.start('demo_nodes_cpp', 'parameter_blackboard')
    client = stage.start('demo_nodes_py', 'async_param_client')
    stage.until(5000)
    texts = stage.texts()
    for text in ('    - int_parameter: 10', '    - string_parameter: Fee Fi Fo Fum', 'Deleting parameters:'):
        assert text in texts
    assert client.returncode == 0


@pytest.mark.parametrize('executable, extra', [('one_off_timer', [(1000.0, 'in one_off_timer callback')]), ('reuse_timer', [])])
def test_the_one_off_timer_fires_a_second_after_its_reset(stage: Any, executable: str, extra: list[Any]) -> None:
    stage.start('demo_nodes_cpp', executable)
    stage.until(4500)
    assert stage.tape.logs == [
        *extra,
        (2000.0, 'in periodic_timer callback'),
        (2000.0, '  resetting one off timer'),
        (3000.0, 'in one_off_timer callback'),
        (4000.0, 'in periodic_timer callback'),
        (4000.0, '  not resetting one off timer'),
    ]


def test_setting_param1_takes_param2_along(stage: Any) -> None:
    from rcl_interfaces.msg import Parameter, ParameterValue
    from rcl_interfaces.srv import SetParametersAtomically

    stage.start('demo_nodes_py', 'set_parameters_callback')
    stage.until(0)
    service = '/set_parameters_callback/set_parameters_atomically'
    for value in (1.5, -1.0):
        stage.ask(
            service,
            SetParametersAtomically,
            parameters=[Parameter(name='param1', value=ParameterValue(type=3, double_value=value))],
        )
    stage.until(10)
    assert stage.texts() == ['param1 is now 1.5', 'param2 is now 4.0']


def test_best_effort_talker_stops_after_its_cycles(stage: Any) -> None:
    process = stage.start('demo_nodes_py', 'talker_qos', '-n', '2')
    stage.until(5000)
    assert stage.texts() == ['Best effort talker', 'Publishing: "Hello World: 0"', 'Publishing: "Hello World: 1"']
    assert process.returncode == 0


def test_serialized_listener_shows_bytes(stage: Any) -> None:
    stage.start('demo_nodes_py', 'listener_serialized')
    stage.until(10)
    stage.publish('/chatter', String(data='hi'))
    stage.until(20)
    assert stage.texts() == [r'''I heard: "b'\x00\x01\x00\x00\x03\x00\x00\x00hi\x00'"''']


def test_set_and_get_parameters_reads_back_what_it_set(stage: Any) -> None:
    process = stage.start('demo_nodes_cpp', 'set_and_get_parameters')
    stage.until(10)
    assert '\nParameter name: baz\nParameter value (double): 1.450000' in stage.texts()[0]
    assert '\nParameter name: foobar\nParameter value (bool): true' in stage.texts()[0]
    assert process.returncode == 0


def test_list_parameters_names_its_own(stage: Any) -> None:
    stage.start('demo_nodes_cpp', 'list_parameters')
    stage.until(10)
    assert stage.texts() == ['Listing parameters...', '\nParameter names:\n foo\n bar\n baz\n foobar\nParameter prefixes:']

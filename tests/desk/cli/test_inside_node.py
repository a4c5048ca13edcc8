"""`ros2 node ...` in the simulation."""

from __future__ import annotations


def test_list_leaves_the_commands_own_node_out(machine) -> None:
    assert machine.read('ros2 node list') == '/sim\n'
    assert machine.read('ros2 node list -c') == '1\n'
    assert machine.read('ros2 node list -a').splitlines()[0].startswith('/_ros2cli_')


def test_two_nodes_of_one_name_are_warned_of(machine) -> None:
    machine.start('ros2 run turtlesim turtlesim_node --ros-args -r __node:=sim')
    machine.session.run(0.1)
    typed = machine.run('ros2 node list')
    assert (typed.out, typed.err) == (
        '/sim\n/sim\n',
        'WARNING: Be aware that there are nodes in the graph that share an exact name, which can have unintended side effects.\n',
    )
    assert machine.run('ros2 node info /sim').err.startswith('There are 2 nodes in the graph with the exact name "/sim".')


def test_info_has_six_sections_and_an_empty_line_for_an_empty_one(machine) -> None:
    text = machine.read('ros2 node info /sim')
    assert [line for line in text.splitlines() if line.endswith(':')] == [
        '  Subscribers:',
        '  Publishers:',
        '  Service Servers:',
        '  Service Clients:',
        '  Action Servers:',
        '  Action Clients:',
    ]
    assert '\n  Service Clients:\n\n  Action Servers:\n    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute\n' in text
    assert text.startswith('/sim\n  Subscribers:\n') and '    /turtle1/pose: turtlesim/msg/Pose\n' in text


def test_info_wants_the_full_name(machine) -> None:
    assert machine.fails('ros2 node info sim') == "Unable to find node 'sim'\n  help: did you mean '/sim'?\n"

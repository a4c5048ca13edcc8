"""`ros2 interface ...` and `ros2 pkg ...` in the simulation."""

from __future__ import annotations

import pytest

TWIST_WITHOUT_COMMENTS = (
    'Vector3 linear\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\nVector3 angular\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\n'
)


def test_show_indents_nested_definitions_by_tabs(machine) -> None:
    assert machine.read('ros2 interface show geometry_msgs/msg/Twist --no-comments') == TWIST_WITHOUT_COMMENTS
    assert machine.read('ros2 interface show geometry_msgs/msg/PoseStamped').startswith(
        'std_msgs/Header header\n\tbuiltin_interfaces/Time stamp\n\t\tint32 sec\n\t\tuint32 nanosec\n\tstring frame_id\n'
    )


def test_show_keeps_the_comments_of_the_outer_type(machine) -> None:
    shown = machine.read('ros2 interface show turtlesim/srv/Spawn')
    assert shown.startswith('float32 x\nfloat32 y\nfloat32 theta #') and '\nstring name # ' in shown
    assert machine.read('ros2 interface show std_srvs/srv/Empty') == '---\n'


def test_show_of_something_unknown(machine) -> None:
    assert machine.fails('ros2 interface show turtlesim/msg/Pos') == (
        "Could not find the interface 'turtlesim/msg/Pos'\n  help: did you mean 'turtlesim/msg/Pose'?\n"
    )
    assert machine.fails('ros2 interface show turtelsim/msg/Pose').startswith("Unknown package 'turtelsim'\n")


def test_lists(machine) -> None:
    assert machine.read('ros2 interface package turtlesim').splitlines()[:3] == [
        'turtlesim/action/RotateAbsolute',
        'turtlesim/msg/Color',
        'turtlesim/msg/Pose',
    ]
    assert 'turtlesim' in machine.read('ros2 interface packages -s').splitlines()
    headings = [line for line in machine.read('ros2 interface list').splitlines() if not line.startswith('    ')]
    assert headings == ['Messages:', 'Services:', 'Actions:']
    assert machine.read('ros2 interface list -a').startswith('Actions:\n    ')


@pytest.mark.parametrize('name', ['std_msgs', '1_000', 'a_b/c_d/e_f'])
def test_what_is_no_name_of_an_interface_is_refused_in_one_sentence(machine, name: str) -> None:
    assert machine.fails(f'ros2 interface proto {name}').count('help: ') == 1
    assert 'Traceback' not in machine.fails(f'ros2 interface show {name}')


def test_proto_can_be_pasted(machine) -> None:
    assert machine.read('ros2 interface proto turtlesim/srv/Kill') == '"name: \'\'\n"\n'
    assert machine.read('ros2 interface proto turtlesim/srv/Kill --no-quotes') == "name: ''\n"


def test_executables_of_turtlesim(machine) -> None:
    names = ('draw_square', 'mimic', 'turtle_teleop_key', 'turtlesim_node')
    assert machine.read('ros2 pkg executables turtlesim') == ''.join(f'turtlesim {name}\n' for name in names)
    assert machine.read('ros2 pkg executables turtlesim --full-path').splitlines()[1].endswith('/lib/turtlesim/mimic')


def test_prefix_and_list(machine) -> None:
    assert machine.read('ros2 pkg prefix --share turtlesim').endswith('/share/turtlesim\n')
    assert machine.fails('ros2 pkg prefix turtelsim') == "Package not found\n  help: did you mean 'turtlesim'?\n"
    assert {'demo_nodes_cpp', 'turtlesim'} <= set(machine.read('ros2 pkg list').splitlines())
    assert machine.read('ros2 pkg xml turtlesim -t name') == 'turtlesim\n'


def test_a_package_is_made_below_the_folder_of_the_command(machine) -> None:
    told = machine.read('ros2 pkg create my_pkg --build-type ament_python --node-name my_node --license MIT')
    assert told.startswith('going to create a new package\npackage name: my_pkg\n')
    made = machine.folder / 'my_pkg'
    assert (made / 'my_pkg' / 'my_node.py').is_file()
    assert '<maintainer email="student@todo.todo">student</maintainer>' in (made / 'package.xml').read_text()
    assert 'The directory already exists' in machine.run('ros2 pkg create my_pkg').err

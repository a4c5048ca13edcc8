"""`ros2 run`, `ros2 launch` and wrong command lines in the simulation."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.runtime.session import Session

C3 = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['ros2 service call turtlesim1/spawn turtlesim/srv/Spawn "{x: 2, y: 2, theta: 0.2}"'], shell=True),
        ExecuteProcess(cmd=['ros2 param set turtlesim1/sim background_r 120'], shell=True),
        TimerAction(period=2.0, actions=[
            ExecuteProcess(cmd=['ros2 param set turtlesim1/sim background_r 200'], shell=True)]),
        Node(package='turtlesim', namespace='turtlesim1', executable='turtlesim_node', name='sim'),
    ])
"""


def test_run_passes_output_arguments_and_ctrl_c_on(machine) -> None:
    typed = machine.run('ros2 run turtlesim turtlesim_node --ros-args -r __node:=other')
    assert typed.err.splitlines()[0].endswith('[other]: Starting turtlesim with node name /other')
    typed.interrupt()
    assert (typed.code, machine.read('ros2 node list')) == (0, '/sim\n')


def test_run_tells_how_a_program_failed(machine) -> None:
    typed = machine.run('ros2 run tf2_ros static_transform_publisher --frame-id world')
    assert typed.code and typed.out.endswith(f'[ros2run]: Process exited with failure {typed.code}\n')


def test_run_of_something_unknown(machine) -> None:
    assert (
        machine.fails('ros2 run turtlesin mimic')
        == "Package 'turtlesin' not found\n  help: the package turtlesin does not exist; write turtlesim if you mean that package\n"
    )
    assert (
        machine.fails('ros2 run turtlesim mimik')
        == "No executable found\n  help: the package 'turtlesim' has no executable named 'mimik'; write 'mimic'\n"
    )
    assert machine.fails('ros2 run turtlesim x').endswith(
        'use one of its executables: draw_square, mimic, turtle_teleop_key, turtlesim_node\n'
    )


def test_a_launch_inside_starts_its_nodes_and_ends_them(machine) -> None:
    typed = machine.run('ros2 launch turtlesim multisim.launch.py')
    assert machine.read('ros2 node list') == '/sim\n/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'
    typed.interrupt()
    assert (typed.code, machine.read('ros2 node list')) == (0, '/sim\n')


def test_launch_shows_arguments_and_refuses_unknown_files(machine) -> None:
    assert machine.read('ros2 launch turtlesim multisim.launch.py -s').endswith('\n\n  No arguments.\n')
    assert machine.fails('ros2 launch turtlesim multi.launch.py').endswith("help: did you mean 'multisim.launch.py'?\n")
    assert machine.fails('ros2 launch turtlesim multisim.launch.py x=1').startswith("malformed launch argument 'x=1'")


def test_an_unknown_command_verb_or_option_is_answered_with_the_nearest(machine) -> None:
    for line, near in (
        ('ros2 topc', '`ros2 topic`'),
        ('ros2 topic eco', '`ros2 topic echo`'),
        ('ros2 topic list --shwo-types', '--show-types'),
    ):
        typed = machine.run(line)
        assert (typed.code, typed.out) == (2, '') and typed.err.startswith('usage: ros2 ')
        assert typed.err.splitlines()[-1].startswith(f'  help: did you mean {near}')
    assert "invalid choice: 'topc' (choose from 'action', 'bag', " in machine.run('ros2 topc').err


def test_help_lists_commands_and_verbs(machine) -> None:
    assert '\n  topic      Various topic related sub-commands\n' in machine.read('ros2')
    assert '\n  echo   Output messages from a topic\n' in machine.read('ros2 topic -h')
    assert machine.read('ros2 topic echo -h').startswith('usage: ros2 topic echo [-h]')


def test_commands_of_a_launch_file_talk_to_its_nodes(tmp_path: Path) -> None:
    path = tmp_path / 'c3.launch.py'
    path.write_text(C3)
    with Session() as session:
        session.launch(path)
        session.run(3.0)
        codes = [row['returncode'] for row in session.recorder.processes]
        red = [(row[0] / 1e9, row[3]) for row in session.recorder.parameters if row[2] == 'background_r']
    assert red == [(0.0, 69), (0.512, 120), (2.016, 200)]
    assert codes == [None, 0, 0, None, 0]


def test_the_seeds_file_records_a_bag(tmp_path: Path, monkeypatch) -> None:
    seed = Path(__file__).resolve().parents[3] / '..' / 'shared/seeds/files/launch_and_parameters/execute_process.launch.py'
    if not seed.exists():
        pytest.skip('the seeds are not here')
    monkeypatch.chdir(tmp_path)
    lines: list[str] = []
    edulaunch.run(seed, duration_s=3, console=lambda stream, text: lines.append(text))
    assert "[ros2-1] [INFO] [1700000000.100000000] [rosbag2_recorder]: Subscribed to topic '/chatter'\n" in lines


def test_programs_that_are_windows_name_the_page_that_shows_the_same(machine) -> None:
    assert '`edulaunch view --tab graph`' in machine.read('ros2 run rqt_graph rqt_graph')
    assert '`edulaunch view --tab log`' in machine.read('ros2 run rqt_console rqt_console')


def test_a_parameter_file_is_found_from_the_folder_of_the_terminal(machine) -> None:
    (machine.folder / 'blue.yaml').write_text('/**:\n  ros__parameters: {background_b: 7}\n')
    machine.run('ros2 run turtlesim turtlesim_node --ros-args -r __node:=other --params-file blue.yaml')
    assert machine.read('ros2 param get /other background_b') == 'Integer value is: 7\n'


LAUNCH = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('word', default_value='a'), LogInfo(msg=LaunchConfiguration('word')),
                              LogInfo(msg=LaunchConfiguration('launch-prefix', default='none'))])
"""


@pytest.mark.parametrize(
    ('words', 'said'),
    [
        ('my.launch.py word:=b -n', ['b', 'none']),
        ('-n my.launch.py word:=b word:=c', ['c', 'none']),
        ('my.launch.py --launch-prefix "xterm -e" word:=b -a', ['b', 'xterm -e']),
        ('./my.launch.py', ['a', 'none']),
    ],
)
def test_options_of_launch_stand_anywhere(machine, words: str, said: list[str]) -> None:
    (machine.folder / 'my.launch.py').write_text(LAUNCH)
    typed = machine.run(f'ros2 launch {words}', 1.0)
    lines = [line.removeprefix('[INFO] [launch.user]: ') for line in typed.out.splitlines() if 'launch.user' in line]
    assert (typed.code, lines) == (0, said)


def test_a_launch_file_by_path_counts_from_the_folder_of_the_terminal(machine) -> None:
    (machine.folder / 'my.launch.py').write_text(LAUNCH)
    assert 'did you mean' in machine.fails('ros2 launch my.lunch.py word:=b')
    assert 'name a launch file of turtlesim' in machine.fails('ros2 launch turtlesim word:=b')


@pytest.mark.parametrize('half', ['\udce9', '\ud800'])
def test_half_a_character_is_an_argument_as_in_cpp(machine, half: str) -> None:
    typed = machine.run(f'ros2 run turtlesim turtlesim_node --ros-args -r __node:=other -p "a:={half}"')
    assert 'Spawning turtle' in typed.err and 'Traceback' not in typed.err
    typed.interrupt()
    assert typed.code == 0

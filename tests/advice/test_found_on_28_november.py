"""Wrong or misleading advice on files of repositories that were drawn on 28 November, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.desk.cli.main import main
from tests.advice.test_found_in_draws import CONFIG, MANIFEST, program, write

NODE_OF_WALKER = 'Node(package="robo", executable="walker"{more})'


def launch_file(*actions: str) -> str:
    listed = ''.join(f'        {action},\n' for action in actions)
    return (
        'from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument, LogInfo\n'
        'from launch.substitutions import LaunchConfiguration\nfrom launch_ros.actions import Node\n\n\n'
        f'def generate_launch_description():\n    return LaunchDescription([\n{listed}    ])\n'
    )


def report(capsys: pytest.CaptureFixture[str], *words: str | Path, code: int = 1) -> str:
    """Return what `edulaunch doctor` prints, and check its exit code."""
    ended = main(['doctor', *map(str, words)])
    printed = capsys.readouterr().out
    assert ended == code, printed
    return printed


def workspace(folder: Path, walker: str, **files: str) -> Path:
    """Write a package with one program, whose CMakeLists.txt installs it, and return its folder."""
    built = 'project(robo)\ninstall(PROGRAMS walker DESTINATION lib/robo)\ninstall(DIRECTORY launch DESTINATION share/robo)\nament_package()\n'
    write(folder / 'src' / 'robo', package_xml=MANIFEST.format(more='', kind='ament_cmake'), CMakeLists_txt=built, **files)
    (folder / 'src' / 'robo' / 'walker').write_text('#!/usr/bin/env python3\n' + walker)
    return folder / 'src' / 'robo'


@pytest.mark.parametrize(
    ('name', 'text', 'cure'),
    [
        ('a.launch.py', launch_file("LogInfo(msg=LaunchConfiguration('speed'))"), "write DeclareLaunchArgument('speed', "),
        ('a.launch.xml', '<launch>\n  <log message="$(var speed)"/>\n</launch>\n', 'write <arg name="speed" default="..."/>'),
        (
            'a.launch.yaml',
            'launch:\n- log: {message: $(var speed)}\n',
            "write `- arg: {name: speed, default: '...'}` before this line",
        ),
    ],
)
def test_a_missing_configuration_is_told_in_the_language_of_the_file_and_without_groups(
    name: str, text: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_text(text)
    printed = report(capsys, tmp_path / name)
    assert "1. the launch configuration 'speed' does not exist" in printed and cure in printed
    assert 'group' not in printed


@pytest.mark.parametrize(
    ('name', 'text', 'cure'),
    [
        (
            'a.launch.py',
            launch_file(
                "Node(package='turtlesim', executable='turtlesim_node', parameters=[{'title': LaunchConfiguration('t')}])"
            ),
            'do:    write ParameterValue(..., value_type=str), with: from launch_ros.parameter_descriptions import ParameterValue',
        ),
        (
            'a.launch.xml',
            '<launch>\n<node pkg="turtlesim" exec="turtlesim_node"><param name="title" value="$(var t)"/></node>\n</launch>\n',
            'do:    add type="str" to the <param> of title',
        ),
        (
            'a.launch.yaml',
            'launch:\n- node:\n    pkg: turtlesim\n    exec: turtlesim_node\n    param:\n    - {name: title, value: $(var t)}\n',
            'do:    add the line `type: str` to the parameter title',
        ),
    ],
)
def test_a_text_that_launch_reads_as_yaml_needs_a_type(
    name: str, text: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_text(text)
    printed = report(capsys, tmp_path / name, 't:=roll: the angle: x')
    assert "the value of the parameter 'title' as YAML, but it is not valid YAML" in printed and cure in printed


def test_a_path_of_one_machine_that_is_a_default_is_not_told_to_become_an_argument(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = "LogInfo(msg=LaunchConfiguration('model'))"
    (tmp_path / 'a.launch.py').write_text(
        launch_file("DeclareLaunchArgument('model', default_value='/home/ada/model.bin')", shown, "LogInfo(msg='/home/ada/b')")
    )
    printed = report(capsys, tmp_path / 'a.launch.py', code=0)
    first, second = printed.split('2. note:')
    assert 'replace the default /home/ada/model.bin with a file of a package' in first + second
    assert (first + second).count('make the path a launch argument') == 1


def test_a_remapping_to_itself_is_a_placeholder_and_no_mistake(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'a.launch.py').write_text(
        launch_file("Node(package='turtlesim', executable='turtlesim_node', remappings=[('turtle1/pose', 'turtle1/pose')])")
    )
    assert report(capsys, tmp_path / 'a.launch.py', code=0) == 'no problems found\n'


def test_a_remapping_of_the_name_of_a_node_is_not_a_misspelt_topic(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    walker = program(
        imports='from std_msgs.msg import String',
        constructor="super().__init__('news_station'); self.news = self.create_publisher(String, 'robot_news', 1)",
    )
    remapped = 'Node(package="robo", executable="walker", name="news_station_bb8", remappings=[("robot_news_station", "{new}")])'
    package = workspace(tmp_path, walker, launch__named_launch_py=launch_file(remapped.format(new='news_station_bb8')))
    printed = report(capsys, package / 'launch' / 'named.launch.py')
    assert 'do:    remove the remapping: news_station_bb8 is the name of the node' in printed
    (package / 'launch' / 'other.launch.py').write_text(launch_file(remapped.format(new='other')))
    printed = report(capsys, package / 'launch' / 'other.launch.py')
    assert 'as the first name' not in printed and 'do:    use one of the names of /news_station_bb8: /robot_news' in printed


def test_a_missing_cmakelists_is_created_and_no_line_of_it_corrected(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(tmp_path / 'robo', package_xml=MANIFEST.format(more='', kind='ament_cmake'))
    printed = report(capsys, tmp_path / 'robo')
    assert (
        'do:    create CMakeLists.txt in the folder of the package, or remove package.xml' in printed and 'correct' not in printed
    )


@pytest.mark.parametrize(
    ('module', 'headline', 'code'),
    [
        ('geographic_msgs', 'note: the module geographic_msgs (interfaces of other packages of ROS) is not part of edulaunch', 0),
        ('rqt_gui', 'note: the module rqt_gui (windows) is not part of edulaunch', 0),
        ('crane_msgs', 'note: the interface package crane_msgs is not in this workspace, and it is not part of edulaunch', 0),
        ('geometri_msgs', 'the interface package geometri_msgs does not exist', 1),
    ],
)
def test_a_package_of_ros_that_is_absent_here_is_a_note(
    module: str, headline: str, code: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workspace(
        tmp_path, program(imports=f'import {module}'), launch__a_launch_py=launch_file(NODE_OF_WALKER.format(more=''))
    )
    assert f'1. {headline}\n' in report(capsys, package / 'launch' / 'a.launch.py', code=code)


def test_a_launch_file_of_a_folder_that_needs_others_gets_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    needs = {
        'launch__a_launch_py': launch_file('Node(package="nav2_bringup_of_mine", executable="x")'),
        'launch__b_launch_py': 'from nav2_common.launch import RewrittenYaml\n' + launch_file(),
    }
    files = {
        'package_xml': MANIFEST.format(more='<exec_depend>ros2launch</exec_depend>', kind='ament_python'),
        'setup_cfg': CONFIG,
    }
    setup = "from setuptools import setup\nsetup(name='robo', version='0.0.1', data_files=[('share/robo/launch', ['launch/a.launch.py', 'launch/b.launch.py'])])\n"
    write(tmp_path / 'robo', setup_py=setup, resource__robo='', **files, **needs)
    printed = report(capsys, tmp_path / 'robo', code=0)
    assert 'launch/a.launch.py did not run: package nav2_bringup_of_mine is not installed' in printed
    assert 'launch/b.launch.py did not run: module nav2_common is not installed' in printed
    assert 'this launch file needs' not in printed


def test_a_program_with_respawn_that_dies_at_once_does_not_stop_the_clock(tmp_path: Path) -> None:
    dying = write(tmp_path, walker_py='import a_module_that_is_not_here\n') / 'walker.py'
    action = f"ExecuteProcess(cmd=['python3', {str(dying)!r}], respawn=True, respawn_max_retries=3)"
    (tmp_path / 'a.launch.py').write_text(
        launch_file(action).replace('DeclareLaunchArgument', 'DeclareLaunchArgument, ExecuteProcess')
    )
    recording = edulaunch.run(tmp_path / 'a.launch.py', duration_s=5.0, console=lambda *_: None)
    assert [one.started_s for one in recording.processes if one.name.startswith('python3')] == [0.0, 0.25, 0.5, 0.75]


def test_the_last_output_of_a_program_shows_no_folder_of_a_simulated_build(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workspace(tmp_path, program(), launch__a_launch_py=launch_file(NODE_OF_WALKER.format(more='')))
    (package / 'walker').write_text('#!/bin/sh\nno_program_of_this_name\n')
    (package / 'walker').chmod(0o755)
    printed = report(capsys, package / 'launch' / 'a.launch.py')
    assert 'do:    check the last output of the program: lib/robo/walker: ' in printed and 'edulaunch-' not in printed


def test_a_function_that_adds_its_node_to_the_launch_description_needs_no_return(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / 'a.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\nfrom launch_ros.actions import Node\n\n\n'
        "def add(context, description):\n    node = Node(package='turtlesim', executable='turtlesim_node')\n"
        '    description.add_action(node)\n\n\n'
        'def generate_launch_description():\n    description = LaunchDescription()\n'
        '    description.add_action(OpaqueFunction(function=add, args=[description]))\n    return description\n'
    )
    assert report(capsys, tmp_path / 'a.launch.py', code=0) == 'no problems found\n'
    recording = edulaunch.run(tmp_path / 'a.launch.py', duration_s=1.0, console=lambda *_: None)
    assert [node.name for node in recording.nodes if 'turtlesim' in node.name] == ['/turtlesim']


def test_a_topic_is_not_paired_with_one_that_another_topic_resembles_more(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mimic = "Node(package='turtlesim', executable='mimic', remappings=[('/input/pose', '/far/{turtle}/pose'), ('/output/cmd_vel', '/far/cmd_vel')])"
    sim = "Node(package='turtlesim', executable='turtlesim_node', namespace='near')"
    spawn = "ExecuteProcess(cmd=['ros2', 'service', 'call', '/near/spawn', 'turtlesim/srv/Spawn', '{{x: 2.0, y: 2.0, name: second}}'])"
    text = launch_file(sim, mimic.format(turtle='turtle1'), spawn.format()).replace('LogInfo', 'ExecuteProcess, LogInfo')
    (tmp_path / 'a.launch.py').write_text(text)
    assert '/near/second/pose' not in report(capsys, tmp_path / 'a.launch.py', code=0)


@pytest.mark.parametrize(
    ('calls', 'headline', 'cure'),
    [
        (
            "self.timer = self.create_timer(1.0, lambda: self.kill.call_async(Kill.Request(name='turtle1')))",
            "1. the turtle 'turtle1' cannot be killed a second time, because it does not exist any more",
            "do:    kill 'turtle1' only once",
        ),
        (
            "self.timer = self.create_timer(1.0, lambda: self.kill.call_async(Kill.Request(name='turtl1')))",
            "1. the turtle 'turtl1' cannot be killed, because it does not exist",
            "do:    write 'turtle1' if you mean this name",
        ),
    ],
)
def test_a_turtle_that_is_killed_twice_is_no_misspelling_of_itself(
    calls: str, headline: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    walker = program(
        imports='from turtlesim.srv import Kill',
        constructor=f"super().__init__('killer'); self.kill = self.create_client(Kill, '/kill'); {calls}",
    )
    package = workspace(
        tmp_path,
        walker,
        launch__a_launch_py=launch_file("Node(package='turtlesim', executable='turtlesim_node')", NODE_OF_WALKER.format(more='')),
    )
    printed = report(capsys, package / 'launch' / 'a.launch.py')
    assert headline in printed and cure in printed


@pytest.mark.parametrize(
    ('remapping', 'cure'),
    [
        (
            "('/turtle1/cmd_vel', '/turtle2/cmd_vel')",
            "remove this remapping, or swap its names if the code of /teleop_turtle uses '/turtle2/cmd_vel'",
        ),
        ("('turtle1/cmd_vel', '/turtle1/cmd_vel')", ''),
    ],
)
def test_names_in_a_program_of_ros_2_are_not_told_to_be_swapped(
    remapping: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    teleop = f"Node(package='turtlesim', executable='turtle_teleop_key', remappings=[{remapping}])"
    (tmp_path / 'a.launch.py').write_text(launch_file("Node(package='turtlesim', executable='turtlesim_node')", teleop))
    edulaunch.run(str(tmp_path / 'a.launch.py'), duration_s=2.0)
    told = capsys.readouterr().err
    assert ('disconnects /teleop_turtle' in told) == bool(cure) and cure in told


@pytest.mark.parametrize(
    ('parent', 'cure'),
    [
        ('turtel1', "write 'turtle1' instead of 'turtel1' where this frame is the parent"),
        ('turtle2', "broadcast a transform between the trees, for example with the parent 'world' and the child 'turtle2'"),
    ],
)
def test_a_misspelt_parent_is_told_and_not_broadcast(
    parent: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = "'--frame-id', '{}', '--child-frame-id', '{}'"
    static = "Node(package='tf2_ros', executable='static_transform_publisher', arguments=[{}])"
    text = (
        'import rclpy\nfrom rclpy.time import Time\nfrom tf2_ros import Buffer, TransformException, TransformListener\n\n'
        "rclpy.init()\nnode = rclpy.create_node('seeker')\nbuffer = Buffer()\nlistener = TransformListener(buffer, node)\n\n\n"
        'def look():\n    try:\n        buffer.lookup_transform("world", "carrot1", Time())\n    except TransformException:\n        pass\n\n\n'
        'node.create_timer(0.5, look)\nrclpy.spin(node)\n'
    )
    (tmp_path / 'seeker.py').write_text(text)
    seeker = f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'seeker.py')!r}])"
    frames = (static.format(words.format('world', 'turtle1')), static.format(words.format(parent, 'carrot1')))
    launch = launch_file(*frames, seeker).replace('import DeclareLaunchArgument', 'import DeclareLaunchArgument, ExecuteProcess')
    (tmp_path / 'a.launch.py').write_text(launch)
    edulaunch.run(str(tmp_path / 'a.launch.py'), duration_s=3.0)
    assert cure in capsys.readouterr().err


def test_a_node_that_is_created_before_a_question_is_only_told_to_wait_for_the_keyboard(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Ctrl-C ends the wait, so at the end of the run no program waits any more."""
    asks = (
        'import rclpy\nfrom std_srvs.srv import Trigger\n\nrclpy.init()\nnode = rclpy.create_node("asker")\n'
        'node.create_service(Trigger, "stop", lambda request, response: response)\ninput("Where to? ")\nrclpy.spin(node)\n'
    )
    package = workspace(tmp_path, asks, main_launch_py=launch_file(NODE_OF_WALKER.format(more='')))
    assert main(['launch', str(package / 'main.launch.py'), '--for', '3', '--fast']) == 0
    told = capsys.readouterr().err
    assert 'walker-1 waits for keyboard input' in told
    assert 'never spins' not in told

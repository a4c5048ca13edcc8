"""`edulaunch launch`: what it warns of while ROS says nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main
from tests.house import ROOT

from .conftest import describe


def test_a_node_that_dies_is_as_silent_as_in_ros_but_for_one_warning(run, tmp_path: Path) -> None:
    code, out, err = run(describe("Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': 'red'}])"))
    assert 'process has died [pid 1002, exit code -6' in out
    assert code == 0 and err.count('\n') == 2 and err.startswith("warning: the parameter 'background_r' of /turtlesim is of type")


def test_how_a_command_ended_that_a_program_runs_is_that_programs_business(run, tmp_path: Path) -> None:
    script = tmp_path / 'runs.py'
    script.write_text("import subprocess, time\ntime.sleep(1)\nsubprocess.run(['ros2', 'nonsense'], capture_output=True)\n")
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', '{script}'])"))
    assert (code, err) == (0, '') and 'finished cleanly' in out


def test_what_a_command_in_a_launch_file_said_to_help_is_told_in_full(run, tmp_path: Path) -> None:
    code, _, err = run(describe("ExecuteProcess(cmd=['ros2', 'launch', 'turtlesim', 'no' * 90 + '_multisim.launch.py'])"))
    *_, help = err.splitlines()
    assert code == 0 and 'died with exit code 1' in err
    assert help == '  help: choose a launch file of turtlesim: multisim.launch.py'


def test_a_misspelt_argument_is_accepted_with_one_warning(run) -> None:
    code, out, err = run(describe("DeclareLaunchArgument('radius', default_value='1')"), 'raduis:=2')
    assert (code, err) == (
        0,
        "warning: no launch file declares the argument 'raduis', so its value has no effect\n"
        "  help: write 'radius:=' instead of 'raduis:='\n",
    )


def test_a_package_that_a_build_would_reject_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'ws').mkdir()
    (tmp_path / 'ws' / 'package.xml').write_text('<package>')
    code, out, err = run(describe("Node(package='turtlesim', executable='turtlesim_node')"), '--workspace', str(tmp_path / 'ws'))
    assert code == 0 and err.startswith('warning: @/ws/package.xml') and err.count('\n') == 1


def test_a_callback_that_waits_for_ever_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'wait.py').write_text(
        'import rclpy\nfrom std_srvs.srv import Empty\nrclpy.init()\nnode = rclpy.create_node("a")\n'
        'node.create_service(Empty, "clear", lambda request, response: response)\nclient = node.create_client(Empty, "clear")\n'
        'async def tick():\n    await client.call_async(Empty.Request())\nnode.create_timer(1.0, tick)\nrclpy.spin(node)\n'
    )
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'wait.py')!r}])"), '--for', '3')
    assert err.startswith('warning: tick() in /a blocks forever in await, waiting for a reply from /clear (')
    assert 'wait.py:8, at 1.00 s)' in err and err.count('\n') == 2


def test_an_argument_that_the_included_file_does_not_declare_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'inner.launch.py').write_text(describe("DeclareLaunchArgument('speed', default_value='1')"))
    code, out, err = run(
        describe(f"IncludeLaunchDescription({str(tmp_path / 'inner.launch.py')!r}, launch_arguments={{'speeed': '3'}}.items())")
    )
    assert (code, err) == (
        0,
        "warning: the argument 'speeed' is passed to inner.launch.py, which does not declare it, so it has no effect "
        "(@/my.launch.py:5)\n  help: write 'speed' instead of 'speeed'\n",
    )


def test_endpoints_that_cannot_talk_because_of_their_types_are_told(run, tmp_path: Path) -> None:
    script = tmp_path / 'hears.py'
    script.write_text(
        'import rclpy\nfrom geometry_msgs.msg import Pose\nrclpy.init()\nnode = rclpy.create_node("hears")\n'
        'node.create_subscription(Pose, "/turtle1/pose", print, 10)\nrclpy.spin(node)\n'
    )
    _, _, err = run(
        describe("Node(package='turtlesim', executable='turtlesim_node')", f"ExecuteProcess(cmd=['python3', '{script}'])")
    )
    assert err == (
        'warning: /turtlesim publishes turtlesim/msg/Pose on /turtle1/pose, but /hears expects geometry_msgs/msg/Pose, '
        'so /hears receives nothing (@/hears.py:5, at 0.00 s)\n  help: use the same message type on both sides, or two topics\n'
    )


def test_a_robot_that_hears_both_types_is_not_warned_of(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['launch', str(ROOT / 'solutions' / 'circle.launch.py'), '--fast', '--for', '2']) == 0
    assert capsys.readouterr().err == ''


def test_a_command_that_ctrl_c_ended_did_not_die(run) -> None:
    words = ['ros2', 'topic', 'pub', '/chatter', 'std_msgs/msg/String', 'data: hello']
    _, _, err = run(describe(f'ExecuteProcess(cmd={words})'))
    assert err == ''
    _, _, err = run(describe(f'ExecuteProcess(cmd={words[:3]})'))
    assert err == (
        'warning: ros2-1 died with exit code 2 (@/my.launch.py:5, at 0.00 s)\n'
        '  help: check the last output of the program: ros2 topic pub: error: the following arguments are required: '
        'topic_name, message_type\n'
    )

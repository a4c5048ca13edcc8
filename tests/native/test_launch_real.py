"""`edulaunch launch --real`: unmodified launch files, each node a process on the real rclpy."""

from __future__ import annotations

import os
import re
import select
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from edulaunch.native.environment import Environment

pytestmark = pytest.mark.real
Run = Callable[..., subprocess.CompletedProcess[str]]
CAUGHT = ('the given context is not valid', "publisher's context is invalid", 'rcl_shutdown already called')
"""What the real rclpy says when Ctrl-C has shut it down while it was about to wait or to publish."""


def ended_well(said: str) -> int:
    """How many programs ended as they should, with those whose rclpy did not catch an error of Ctrl-C: it is its own."""
    caught = any(words in said for words in CAUGHT)
    return said.count('process has finished cleanly') + (said.count('exit code 1, ') if caught else 0)


FOLLOWED = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit
from launch_ros.substitutions import FindPackageShare
from launch.substitutions import PathJoinSubstitution

def generate_launch_description():
    watcher = ExecuteProcess(cmd=['python3', 'watch.py'], output='screen')
    return LaunchDescription([
        IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('turtle_tf2_py'), 'launch', 'turtle_tf2_demo.launch.py'])),
        watcher,
        RegisterEventHandler(OnProcessExit(target_action=watcher, on_exit=[Shutdown(reason='seen')])),
    ])
"""
WATCH = """
from math import hypot
import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose

class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        self.poses, self.far = {}, 0.0
        for name in ('turtle1', 'turtle2'):
            self.create_subscription(Pose, f'/{name}/pose', lambda pose, name=name: self.on_pose(name, pose), 10)

    def on_pose(self, name, pose):
        self.poses[name] = pose
        if len(self.poses) == 2:
            one, two = self.poses.values()
            distance = hypot(one.x - two.x, one.y - two.y)
            self.far = max(self.far, distance)
            if self.far > 3.0 and distance < 1.0:
                print('turtle2 came to turtle1', flush=True)
                raise SystemExit(0)

rclpy.init()
rclpy.spin(Watcher())
"""


def test_turtle2_follows_in_the_demo(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'watch.py').write_text(WATCH)
    (tmp_path / 'followed.launch.py').write_text(FOLLOWED)
    done = edulaunch('launch', '--real', 'followed.launch.py', '--for', '100')
    said = done.stdout
    assert 'turtle2 came to turtle1' in said, said + done.stderr
    assert ended_well(said) == 5, said
    assert 'Successfully spawned turtle2' in said
    assert done.returncode == 0


COMMANDS = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node

def generate_launch_description():
    commands = [
        ['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 2.0, y: 3.0, name: leo}'],
        ['ros2', 'param', 'set', '/sim', 'background_r', '200'],
        ['ros2', 'param', 'set', '/sim', 'background_r', '300'],
        ['ros2', 'topic', 'echo', '--once', '/leo/pose', 'turtlesim/msg/Pose'],
        ['ros2', 'action', 'send_goal', '/leo/rotate_absolute', 'turtlesim/action/RotateAbsolute', '{theta: 0.1}'],
    ]
    steps = [ExecuteProcess(cmd=words, output='screen') for words in commands]
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{'background_r': 10}]),
        steps[0],
        *(RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[second])) for first, second in zip(steps, steps[1:])),
        RegisterEventHandler(OnProcessExit(target_action=steps[-1], on_exit=[Shutdown()])),
    ])
"""


def test_commands_of_a_launch_file_reach_real_nodes(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'commands.launch.py').write_text(COMMANDS)
    said = edulaunch('launch', '--real', 'commands.launch.py', '--for', '100').stdout
    for text in (
        "turtlesim.srv.Spawn_Response(name='leo')",
        'Set parameter successful',
        "Parameter {background_r} doesn't comply with integer range.",
        'x: 2.0',
        'Goal finished with status: SUCCEEDED',
    ):
        assert text in said, said


def test_a_program_that_cannot_run_says_so_as_in_the_simulation(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'x.launch.xml').write_text('<launch><node pkg="nav2_bringup" exec="bringup" name="a"/></launch>')
    done = edulaunch('launch', '--real', 'x.launch.xml', '--for', '20')
    simulated = edulaunch('launch', 'x.launch.xml', '--for', '20')
    assert done.returncode == simulated.returncode
    assert done.stdout.replace(done.stdout.split('pid [')[-1], '') == simulated.stdout.replace(
        simulated.stdout.split('pid [')[-1], ''
    )


def test_the_clock_cannot_be_hurried(real: Environment, edulaunch: Run) -> None:
    done = edulaunch('launch', '--real', '--fast', 'turtlesim', 'multisim.launch.py')
    assert (done.returncode, done.stderr) == (2, 'error: --fast needs simulated time.\n  help: leave out --fast, or --real\n')


STEERED = """
from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessIO
from launch.events import matches_action
from launch_ros.actions import ComposableNodeContainer, LifecycleNode, LoadComposableNodes
from launch_ros.descriptions import ComposableNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition

def generate_launch_description():
    node = LifecycleNode(package='lifecycle', executable='lifecycle_talker', name='lc_talker', namespace='')
    steps = [
        EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=step))
        for step in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE)
    ]
    box = ComposableNodeContainer(
        name='box', namespace='', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[ComposableNode(package='composition', plugin='composition::Talker', name='talker')],
    )
    more = ComposableNode(package='composition', plugin='composition::Listener', name='listener')
    seen = set()

    def hear(event):
        seen.update(word for word in (b'Publishing: [Lifecycle', b'I heard: [Hello') if word in event.text)
        return [Shutdown(reason='both')] if len(seen) == 2 else None

    return LaunchDescription([
        node, box, steps[0], LoadComposableNodes(target_container='box', composable_node_descriptions=[more]),
        RegisterEventHandler(OnStateTransition(target_lifecycle_node=node, goal_state='inactive', entities=[steps[1]])),
        RegisterEventHandler(OnProcessIO(on_stdout=hear, on_stderr=hear)),
    ])
"""


def test_launch_itself_reaches_real_nodes(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'steered.launch.py').write_text(STEERED)
    done = edulaunch('launch', '--real', 'steered.launch.py', '--for', '100')
    assert "Loaded node '/listener' in container 'box'" in done.stdout, done.stdout + done.stderr
    assert ended_well(done.stdout) == 2, done.stdout
    assert 'ctrl-c' not in done.stdout


def test_nodes_end_with_a_launch_that_is_killed(real: Environment, tmp_path: Path) -> None:
    launch = [sys.executable, '-m', 'edulaunch', 'launch', '--real', 'demo_nodes_cpp', 'talker_listener_launch.py']
    with subprocess.Popen(launch, stdout=subprocess.PIPE, text=True, cwd=tmp_path, stdin=subprocess.DEVNULL) as child:
        assert child.stdout is not None
        numbers: list[int] = []
        for line in child.stdout:
            numbers += map(int, re.findall(r'process started with pid \[(\d+)\]', line))
            if 'I heard' in line:
                break
        ends = [os.pidfd_open(number) for number in numbers]
        child.send_signal(signal.SIGKILL)
    assert len(ends) == 2
    for end in ends:
        assert select.select([end], [], [], 60.0)[0], 'a node outlives its launch'
        os.close(end)


SHELL = """
import os, subprocess, rclpy
from rclpy.node import Node
rclpy.init()
node = Node('caller')
os.system('ros2 topic pub -r 5 /beat std_msgs/msg/Empty > /dev/null 2>&1 & echo "number $!"')
print('said', subprocess.run(['ros2', 'topic', 'info', '/rosout'], capture_output=True, text=True).stdout.split()[:2], flush=True)
"""


def test_programs_start_commands_of_ros2_themselves_and_none_outlives_the_launch(
    real: Environment, edulaunch: Run, tmp_path: Path
) -> None:
    (tmp_path / 'caller.py').write_text(SHELL)
    (tmp_path / 'x.launch.xml').write_text('<launch><executable cmd="python3 caller.py" output="screen"/></launch>')
    said = edulaunch('launch', '--real', 'x.launch.xml', '--for', '100').stdout
    number = re.search(r'number (\d+)', said)
    assert number is not None and "said ['Type:', 'rcl_interfaces/msg/Log']" in said, said
    assert not Path('/proc', number[1]).exists() or 'ros2' not in Path('/proc', number[1], 'cmdline').read_text()


def test_recording_a_bag_is_refused_in_a_sentence(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'record.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        "def generate_launch_description():\n    return LaunchDescription([ExecuteProcess(cmd=['ros2', 'bag', 'record', '-a'], output='screen')])\n"
    )
    done = edulaunch('launch', '--real', 'record.launch.py', '--for', '3')
    assert 'ros2 bag record takes its messages from the simulation: leave out --real' in done.stdout + done.stderr
    assert 'Traceback' not in done.stdout + done.stderr

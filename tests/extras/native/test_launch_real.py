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
import yaml

from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native.environment import Environment
from edulaunch.runtime.session import Session

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
    assert (done.returncode, done.stderr) == (2, 'error: --fast needs simulated time.\n  help: leave out --fast or --real\n')


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


CALLER = """
import os, subprocess, rclpy
from rclpy.node import Node
rclpy.init()
node = Node('caller')
os.system('ros2 topic pub -r 5 /beat std_msgs/msg/Empty > /dev/null 2>&1 & echo "number $!"')
os.system('ros2 run demo_nodes_py talker > /dev/null 2>&1 & echo "number $!"')

def said(*words):
    done = subprocess.run(['ros2', *words], capture_output=True, text=True)
    print(words[0], done.returncode, (done.stdout + done.stderr).split(chr(10))[:2], flush=True)

said('topic', 'info', '/rosout')
said('run', 'demo_nodes_py', 'no_such')
said('component', 'types', 'composition')
said('doctor', '--report', '-ep')
while 'talker' not in node.get_node_names():
    rclpy.spin_once(node, timeout_sec=0.1)
print('all said', flush=True)
rclpy.spin(node)
"""


def test_programs_start_commands_of_ros2_themselves_and_none_outlives_the_launch(real: Environment, tmp_path: Path) -> None:
    """Nor one that is killed: `ros2 topic pub` is a program of its own, `ros2 run` starts one more."""
    (tmp_path / 'caller.py').write_text(CALLER)
    (tmp_path / 'x.launch.xml').write_text('<launch><executable cmd="python3 caller.py" output="screen"/></launch>')
    launch = [sys.executable, '-m', 'edulaunch', 'launch', '--real', 'x.launch.xml']
    with subprocess.Popen(launch, stdout=subprocess.PIPE, text=True, cwd=tmp_path, stdin=subprocess.DEVNULL) as child:
        assert child.stdout is not None
        said, ends = '', []
        for line in child.stdout:
            said += line
            if 'number ' in line:
                ends.append(os.pidfd_open(int(line.split()[-1])))
            if 'all said' in line:
                break
        child.send_signal(signal.SIGKILL)
    assert "topic 0 ['Type: rcl_interfaces/msg/Log', 'Publisher count: " in said, said
    assert "run 1 ['No executable found', " in said
    assert "component 0 ['composition::" in said
    assert "doctor 0 ['', '   NETWORK CONFIGURATION'" in said
    assert len(ends) == 2
    for end in ends:
        assert select.select([end], [], [], 60.0)[0], 'a command outlives its launch'
        os.close(end)


LINE = """<launch><executable cmd="bash -c &quot;for topic in /rosout; do ros2 topic type $topic; done; uname&quot;" output="screen"/></launch>"""


def test_a_real_shell_asks_the_real_nodes(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    """A line that the simulated shell does not know runs in the system's, where `ros2` is that of the launch."""
    (tmp_path / 'x.launch.xml').write_text(LINE)
    said = edulaunch('launch', '--real', 'x.launch.xml', '--for', '100').stdout
    assert '[bash-1] rcl_interfaces/msg/Log\n[bash-1] Linux\n' in said, said


RECORDED = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit, OnProcessIO
from launch_ros.actions import Node

def generate_launch_description():
    record = ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'bag', '-e', 'turtle1|chatter'], output='screen')
    say = ExecuteProcess(cmd=['ros2', 'topic', 'pub', '--times', '20', '-r', '10', '/chatter', 'std_msgs/msg/String', 'data: hi'])
    heard = lambda event: [say] if b'/turtle1/pose' in event.text else None
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        record,
        RegisterEventHandler(OnProcessIO(target_action=record, on_stderr=heard, on_stdout=heard)),
        RegisterEventHandler(OnProcessExit(target_action=say, on_exit=[Shutdown()])),
    ])
"""


def test_a_bag_of_real_nodes_is_told_of_and_played_in_the_simulation(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'record.launch.py').write_text(RECORDED)
    done = edulaunch('launch', '--real', 'record.launch.py', '--for', '100')
    assert 'Recording stopped' in done.stdout and 'Traceback' not in done.stdout, done.stdout + done.stderr
    bag = yaml.safe_load((tmp_path / 'bag' / 'metadata.yaml').read_text())['rosbag2_bagfile_information']
    counts = {
        each['topic_metadata']['name']: (each['topic_metadata']['type'], each['message_count'])
        for each in bag['topics_with_message_count']
    }
    assert counts['/turtle1/pose'][0] == 'turtlesim/msg/Pose' and counts['/turtle1/pose'][1] > 60
    assert counts['/chatter'][0] == 'std_msgs/msg/String' and 1 <= counts['/chatter'][1] <= 20
    with Session() as session:
        words = ('ros2', 'bag', 'play', str(tmp_path / 'bag'), '--topics', '/chatter')
        session.host.start(ProcessSpec(argv=words, name='play'))
        session.run(10.0 + bag['duration']['nanoseconds'] / 1e9)  # on a busy computer twenty messages take longer
        assert [str(message.data) for _, message in session.recording().messages('/chatter')] == ['hi'] * counts['/chatter'][1]

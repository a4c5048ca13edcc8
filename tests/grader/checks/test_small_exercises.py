"""The exercises whose rubric is YAML: near misses fail in the check that is about them. (That every solution gets all points says
`python -m edugrade.course_check`, a step of `.ci/run`.)
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from edugrade.grading import WarmGrader, grade, plan_work
from edugrade.submission import Submission

SOLUTIONS = Path(__file__).resolve().parents[3] / 'solutions'
MISSES = [
    (
        'two_rooms.launch.py',
        "executable='listener', namespace='hall')",
        "executable='listener', namespace='hall', remappings=[('chatter', '/cellar/chatter')])",
        'first_heard',
    ),
    ('lost_carrot.launch.py', "        broadcaster('turtle2'),\n", "        broadcaster('turtle1'),\n", 'moves'),
    (
        'two_rooms.launch.py',
        "namespace='hall'),\n        Node(package='demo_nodes_py', executable='listener', namespace=room",
        "namespace='hall'),\n        Node(package='demo_nodes_py', executable='listener', namespace='kitchen'",
        'other',
    ),
    ('two_rooms.launch.py', "('chatter', '/hall/chatter')", "('/chatter', '/hall/chatter')", 'heard'),
    (
        'silent_listener.launch.py',
        "name='radio', remappings=[('chatter',",
        "name='radio', remappings=[('/chattr',",
        'first_hears',
    ),
    ('water.launch.py', 'LaunchConfiguration(colour)', "LaunchConfiguration('red')", 'green_water'),
    ('water.launch.py', "default_value='86'", "default_value='87'", 'green'),
    ('on_request.launch.py', 'condition=IfCondition(drive)', "condition=IfCondition('true')", 'quiet'),
    ('on_request.launch.py', "EqualsSubstitution(worlds, '2')", "EqualsSubstitution(worlds, '1')", 'quiet'),
    ('fence.launch.py', "SetParameter('background_b', blue)", "SetParameter('background_b', 40)", 'fenced_water'),
    ('in_order.launch.py', 'period=delay', 'period=2.0', 'after_driver'),
    ('in_order.launch.py', 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[driver]))', 'driver', 'after_sim'),
    ('rooms.launch.xml', '$(var room)', 'kitchen', 'lives'),
    ('tower.launch.py', "'--yaw', '1.5708'", "'--yaw', '-1.5708'", 'lamp_place'),
    ('mast.launch.py', 'xyz="0 0 0.3"', 'xyz="0 0.3 0"', 'camera_place'),
    ('mast.launch.py', "position: [', angle", "position: [', '0.5'", 'angle'),
    (
        'visitors.launch.py',
        "spawn('{x: ', LaunchConfiguration('x'), ', y: 2.0, name: carl}')",
        "spawn('{x: 3.0, y: 2.0, name: carl}')",
        'visitor_two',
    ),
    ('lost_carrot.launch.py', "{'target_frame': 'carrot1'}", "{'target_frame': 'turtle1'}", 'asked'),
    (
        'careful.launch.py',
        'target_action=echo, on_exit=[driver]',
        'target_action=echo, on_exit=[TimerAction(period=2.0, actions=[driver])]',
        'after_word',
    ),
    (
        'careful.launch.py',
        'RegisterEventHandler(OnProcessExit(target_action=echo, on_exit=[driver]))',
        'TimerAction(period=1.1, actions=[driver])',
        'after_word',
    ),
    ('careful.launch.py', 'period=end', 'period=5.0', 'ends'),
    ('careful.launch.py', "actions=[Shutdown(reason='that is enough')]", 'actions=[]', 'ends'),
    ('news_desk/setup.py', "glob('config/*')", "glob('confg/*')", 'word'),
    ('news_desk/setup.py', 'news_desk.listen:main', 'news_desk.hello:main', 'hears'),
    ('two_turtles/two_turtles/broadcaster.py', 'child_frame_id = self.turtle', "child_frame_id = 'turtle2'", 'first'),
    ('two_turtles/two_turtles/broadcaster.py', 'sin(pose.theta / 2)', 'sin(pose.theta)', 'follows'),
    ('where_now/where_now/where.py', "self.say('newest', Time())", "self.say('newest', now)", 'newest'),
    ('where_now/where_now/where.py', 'now - self.ago', 'now - Duration(seconds=0.5)', 'longer'),
    ('two_seas/launch/two_seas.launch.py', 'blue=blue', "blue='200'", 'south_blue'),
    ('two_seas/config/sea.yaml', '/**/sim', '/*/sin', 'south_red'),
    ('black_box.launch.py', 'on_start=[drive]', 'on_start=[]', 'driver'),
    ('black_box.launch.py', "['/', robot, '/turtle1/pose']", "'/red/turtle1/pose'", 'poses'),
    ('two_pools.launch.py', "'input/pose'", "'input'", 'listens'),
    ('fence.launch.py', "Node(**WORLD, namespace='day')", "Node(**{**WORLD, 'executable': 'mimic'}, namespace='day')", 'nodes'),
    (
        'on_request.launch.py',
        "executable='turtlesim_node', name='sim', namespace='one'",
        "executable='mimic', name='sim', namespace='one'",
        'quiet',
    ),
    ('mast.launch.py', 'continuous">', 'prismatic"><limit lower="0" upper="1" effort="1" velocity="1"/>', 'turns'),
    (
        'water.launch.py',
        "        Node(\n            package='turtlesim', executable='turtlesim_node', name='sim',",
        "        Node(package='turtlesim', executable='turtlesim_node', name='other', namespace='x'),\n"
        "        Node(\n            package='turtlesim', executable='turtlesim_node', name='sim',",
        'red_water',
    ),
    (
        'two_channels/two_channels/counter.py',
        'on_message, 10)',
        'on_message, rclpy.qos.QoSProfile(depth=9, durability=rclpy.qos.DurabilityPolicy.TRANSIENT_LOCAL))',
        'first_heard',
    ),
    ('two_pools.launch.py', "'/first/turtle1/cmd_vel'", "'/second/turtle1/cmd_vel'", 'circle'),
]


@pytest.fixture(scope='module')
def failed() -> Iterator[Callable[[Path], list[str]]]:
    """A function that grades a submission and returns the names of the checks that failed. One starter serves them all."""
    grader = WarmGrader()
    yield lambda path: [
        result.name for result in grader.report(plan_work(Submission(str(path)))).results if result.status == 'failed'
    ]
    grader.close()


@pytest.mark.processes
@pytest.mark.parametrize(('name', 'old', 'new', 'check'), MISSES)
def test_a_near_miss_fails_where_it_misses(
    failed: Callable[[Path], list[str]], tmp_path: Path, name: str, old: str, new: str, check: str
) -> None:
    text, top = (SOLUTIONS / name).read_text(), name.split('/')[0]
    assert text.count(old) == 1, name
    if top != name:
        shutil.copytree(SOLUTIONS / top, tmp_path / top)
    (tmp_path / name).write_text(text.replace(old, new))
    assert check in failed(tmp_path / top)


RELAY = """
import rclpy
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from turtlesim.msg import Pose


def relay():
    rclpy.init()
    node = rclpy.create_node('relay')
    publisher = node.create_publisher(String, '/relay', 10)
    node.create_subscription(Pose, '/turtle1/pose', lambda m: publisher.publish(String(data=f'{m.x} {m.y}')), 10)
    rclpy.spin(node)


def main():
    rclpy.init()
    node = rclpy.create_node('where')
    ago, known, began = node.declare_parameter('ago', 0.5).value, [], []

    def now():
        return node.get_clock().now().nanoseconds / 1e9

    def say():
        for word, age in (('newest', 0.0), ('before', ago)):
            if began and now() - age > began[0]:
                time, x, y = min(known, key=lambda each: abs(each[0] - now() + age))
                node.get_logger().info(f'{word}: {float(x):.2f} {float(y):.2f}, {now() - time:.2f} s old')

    node.create_subscription(String, '/relay', lambda m: known.append((now(), *m.data.split())), 10)
    node.create_subscription(TFMessage, '/tf', lambda m: began.append(now()), 10)
    node.create_timer(1.0, say)
    rclpy.spin(node)
"""
TELEPORTS = """
from math import cos, sin

import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose
from turtlesim.srv import TeleportAbsolute


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        me, target = self.declare_parameter('me', '').value, self.declare_parameter('target', '').value
        self.client = self.create_client(TeleportAbsolute, f'/{me}/teleport_absolute')
        self.create_subscription(Pose, f'/{target[7:]}/pose', self.on_pose, 10)

    def on_pose(self, pose):
        x, y = pose.x - cos(pose.theta), pose.y - sin(pose.theta)
        self.client.call_async(TeleportAbsolute.Request(x=x, y=y, theta=pose.theta))


def main():
    rclpy.init()
    rclpy.spin(Follower())
"""
PRETENDED = {
    'a listener that knows what it will hear': (
        'news_desk',
        'prints',
        ('news_desk/listen.py', '{message.data}', 'ships come in'),
        ('news_desk/hello.py', 'data=self.word', "data='x'"),
    ),
    'a listener that prints by the clock': (
        'news_desk',
        'prints',
        (
            'news_desk/listen.py',
            'self.on_greeting, 10)',
            "print, 10)\n        self.create_timer(0.25, lambda: self.on_greeting(String(data='ships come in')))",
        ),
    ),
    'a word that is not from the file': (
        'news_desk',
        'word',
        ('news_desk/hello.py', 'nothing new', 'ships come in'),
        ('config/news.yaml', '    word:', '    other:'),
    ),
    'a counter that begins anew': (
        'two_channels',
        'counts_on',
        ('two_channels/counter.py', 'self.count += 1', "self.get_logger().info('messages: 1')"),
        ('two_channels/counter.py', '{self.count}', '2'),
    ),
    'a counter that says two before it has heard anything': (
        'two_channels',
        'counts_on',
        ('two_channels/counter.py', 'self.count = 0', "self.get_logger().info('messages: 2')"),
        ('two_channels/counter.py', 'self.count += 1', 'return'),
    ),
    'positions that a program beside it has received': (
        'where_now',
        'newest',
        ('where_now/where.py', '', RELAY),
        ('setup.py', "'where = where_now.where:main'", "'relay = where_now.where:relay', 'where = where_now.where:main'"),
        (
            'launch/where_now.launch.py',
            "        Node(package='where_now', executable='where'",
            "        Node(package='where_now', executable='relay'),\n        Node(package='where_now', executable='where'",
        ),
    ),
    'followers that jump': ('convoy', 'each_is_near_its_carrot', ('convoy/follower.py', '', TELEPORTS)),
}


@pytest.mark.processes
@pytest.mark.parametrize(
    ('file', 'old', 'new', 'line'),
    [
        ('launch/convoy.launch.py', "f'turtle{number - 1}'}", "'turtle1'}", "names = {'me'"),
        ('launch/follower.launch.py', "'target': ['carrot_', leader]", "'target': leader", "parameters=[{'me'"),
    ],
)
def test_a_wrong_leader_has_the_place_that_chooses_it(tmp_path: Path, file: str, old: str, new: str, line: str) -> None:
    shutil.copytree(SOLUTIONS / 'convoy', tmp_path / 'convoy')
    path = tmp_path / 'convoy' / file
    path.write_text(path.read_text().replace(old, new))
    (report,) = grade([plan_work(Submission(str(tmp_path / 'convoy')))])
    (failed,) = [result for result in report.results if result.status == 'failed']
    assert failed.where is not None and failed.where.file.endswith(file)
    assert path.read_text().splitlines()[(failed.where.line or 0) - 1].strip().startswith(line)


@pytest.mark.processes
@pytest.mark.parametrize('name', PRETENDED)
def test_what_is_only_pretended_fails(failed: Callable[[Path], list[str]], tmp_path: Path, name: str) -> None:
    exercise, check, *changes = PRETENDED[name]
    shutil.copytree(SOLUTIONS / exercise, tmp_path / exercise)
    for file, old, new in changes:
        text = (tmp_path / exercise / file).read_text()
        assert old in text, file
        (tmp_path / exercise / file).write_text(text.replace(old, new) if old else new)
    assert check in failed(tmp_path / exercise)

"""Solutions with one edit: (file in the package, or '' for a launch file; old text; new text; the points that it deserves).

A name begins with the exercise. The edits that deserve 12 points are unusual right answers; the others are mistakes of students.
"""

from __future__ import annotations

from typing import NamedTuple

from tests.house import ROOT


class Edit(NamedTuple):
    """One edit of a solution. `old` '' replaces the whole file."""

    file: str
    old: str
    new: str
    points: int


LISTEN = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listen(Node):
    def __init__(self):
        super().__init__('listen')
        self.queue = []
        self.create_subscription(String, 'greeting', self.queue.append, 10)
        self.create_timer(0.3, self.tick)

    def tick(self):
        while self.queue:
            self.get_logger().info('I heard: ' + self.queue.pop(0).data)


def main():
    rclpy.init()
    rclpy.spin(Listen())
"""
SECTIONS = 'north:\n  sim:\n' + '    ros__parameters: {background_r: 20, background_g: 60}\n'
SECTIONS += SECTIONS.replace('north', 'south')
OTHER_TOPICS = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def world(name, topic):
    return Node(package='turtlesim', executable='turtlesim_node', namespace=name, remappings=[('turtle1/cmd_vel', topic)])


def generate_launch_description():
    values = ['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 1.0}}']
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0'), world('first', '/a/drive'), world('second', '/b/drive'),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', '/a/drive', 'geometry_msgs/msg/Twist', values]),
        Node(package='turtlesim', executable='mimic', name='mimic', remappings=[
            ('input/pose', '/first/turtle1/pose'), ('output/cmd_vel', '/b/drive'),
        ]),
    ])
"""
IN_ORDER = (ROOT / 'solutions' / 'in_order.launch.py').read_text()
ONE_HANDLER = IN_ORDER.replace('on_start=[driver]', 'on_start=[driver, TimerAction(period=delay, actions=[late])]').replace(
    '        RegisterEventHandler(OnProcessStart(target_action=driver, on_start=[TimerAction(period=delay, actions=[late])])),\n',
    '',
)
COUNTER, WHERE, BROADCASTER = 'two_channels/counter.py', 'where_now/where.py', 'two_turtles/broadcaster.py'
EDITS = {
    'careful: echo with its type': Edit('', "'/chatter', '--once'", "'/chatter', 'std_msgs/msg/String', '--once'", 12),
    'careful: a function waits': Edit('', 'on_exit=[driver]', 'on_exit=lambda event, context: [driver]', 12),
    'careful: echo never ends': Edit('', ", '--once'", '', 5),
    'careful: echo of another topic': Edit('', "'/chatter', '--once'", "'/chat', '--once'", 4),
    'careful: a fixed end': Edit('', 'period=end', 'period=5.0', 7),
    'two_pools: other topics of commands': Edit('', '', OTHER_TOPICS, 12),
    'two_pools: mimic drives the first turtle': Edit('', "'/second/turtle1/cmd_vel'", "'/first/turtle1/cmd_vel'", 10),
    'black_box: every topic': Edit('', "'my_drive', *topics]", "'my_drive', '-a']", 12),
    'black_box: a misspelt topic': Edit('', '/turtle1/pose', '/turtle1/poses', 9),
    'fence: a parameter of the node': Edit(
        '',
        "            SetParameter('background_b', blue),\n            Node(**WORLD),",
        "            Node(**WORLD, parameters=[{'background_b': blue}]),",
        12,
    ),
    'black_box: a driver in the list': Edit(
        '', 'RegisterEventHandler(OnProcessStart(target_action=recorder, on_start=[drive]))', 'drive', 8
    ),
    'black_box: a shell records': Edit('', '*topics])', '*topics], shell=True)', 12),
    'in_order: one handler for both': Edit('', '', ONE_HANDLER, 8),
    'in_order: a list and a timer': Edit(
        '', 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[driver]))', 'driver', 10
    ),
    'in_order: a fixed delay': Edit('', 'TimerAction(period=delay,', 'TimerAction(period=5.0,', 8),
    'lost_carrot: another target': Edit('', "{'target_frame': 'carrot1'}", "{'target_frame': 'turtle1'}", 5),
    'mast: a joint that cannot move': Edit('', 'type="continuous"', 'type="fixed"', 6),
    'on_request: a value that nobody gives': Edit('', "EqualsSubstitution(worlds, '2')", "EqualsSubstitution(worlds, 'two')", 7),
    'on_request: a driver when nobody wants one': Edit(
        '', 'condition=IfCondition(drive)', "condition=IfCondition(EqualsSubstitution(drive, 'false'))", 4
    ),
    'silent_listener: a misspelt topic': Edit('', '/news/chatter', '/new/chatter', 2),
    'tower: degrees': Edit('', "'1.5708'", "'90'", 8),
    'two_rooms: no remapping': Edit('', ", remappings=[('chatter', '/hall/chatter')]", '', 8),
    'visitors: another y': Edit('', ', y: 2.0, name: carl', ', y: 3.0, name: carl', 6),
    'rooms: a fixed room': Edit('', 'namespace="$(var room)"', 'namespace="kitchen"', 5),
    'news_desk: print': Edit(
        'news_desk/listen.py', "self.get_logger().info(f'I heard: {message.data}')", "print('I heard:', message.data)", 12
    ),
    'news_desk: a queue that is read from time to time': Edit('news_desk/listen.py', '', LISTEN, 12),
    'two_channels: each message counts twice': Edit(COUNTER, 'self.count += 1', 'self.count += 2', 5),
    'two_channels: one channel': Edit(COUNTER, "            f'/{first}/chatter',\n", '', 6),
    'where_now: it asks before it looks up': Edit(
        WHERE,
        '        try:\n            found',
        "        if not self.buffer.can_transform('world', 'turtle1', time):\n            return\n        try:\n            found",
        12,
    ),
    'where_now: the future': Edit(WHERE, 'now - self.ago', 'now + self.ago', 6),
    'where_now: now is too early': Edit(WHERE, "self.say('newest', Time())", "self.say('newest', now)", 7),
    'two_turtles: a wrong quaternion': Edit(BROADCASTER, 'sin(pose.theta / 2)', 'sin(pose.theta)', 8),
    'two_seas: namespaces and names': Edit('config/sea.yaml', '', SECTIONS, 12),
    'two_seas: all nodes': Edit('config/sea.yaml', '/**/sim', '/**', 12),
    'two_seas: an argument of another name': Edit('launch/two_seas.launch.py', 'blue=blue', 'south_blue=blue', 8),
    'convoy: another gain': Edit('convoy/follower.py', '1.5 * hypot', '2.0 * hypot', 12),
    'convoy: everybody follows turtle1': Edit('launch/convoy.launch.py', "f'turtle{number - 1}'}", "'turtle1'}", 5),
    'convoy: one follower less': Edit('launch/convoy.launch.py', '>= {number - 1}', '> {number - 1}', 3),
    'convoy: nobody waits': Edit(
        'launch/convoy.launch.py', 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=row)),', '*row,', 10
    ),
}

"""Packages that put something else in the place of what a check measures: copies of solutions with other texts for some of their files."""

from __future__ import annotations

from typing import NamedTuple

from tests.house import ROOT


class PackageAttack(NamedTuple):
    """A copy of a solution in which other texts stand for some of its files, and the most points that it may get."""

    exercise: str
    most: int
    files: dict[str, str]


HEAD = 'import rclpy\nfrom rclpy.node import Node\n'
MAIN = '\n\ndef main():\n    rclpy.init()\n    rclpy.spin({}())\n'
LISTEN = """from std_msgs.msg import String


class Listen(Node):
    def __init__(self):
        super().__init__('listen')
        self.last = None
        self.subscription = self.create_subscription(String, 'greeting', self.on_greeting, 10)
        self.create_timer({period}, self.tick)

    def on_greeting(self, message):
        self.last = message.data

    def tick(self):
        if self.last is not None:
            self.get_logger().info(f'I heard: {{self.last}}')
"""
COUNT = """from std_msgs.msg import String


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        first = self.declare_parameter('first', 'red').value
        self.count, self.start, self.late = 0, self.now(), None
        self.create_subscription(String, f'/{first}/chatter', self.on_message, 10)
        self.create_subscription(String, '/blue/chatter', bool, 10)

    def now(self):
        return self.get_clock().now().nanoseconds / 1e9

    def on_message(self, message):
        self.say()
        if self.late is None:
            self.late = self.now() - self.start - 1.0
            self.once = self.create_timer(max(self.late, 0.01), self.begin)

    def begin(self):
        self.once.cancel()
        self.say()
        self.create_timer(1.0, self.say)

    def say(self):
        self.count += 1
        self.get_logger().info(f'messages: {self.count}')
"""
WHERE = """from math import cos, sin


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.ago, self.turn = (self.declare_parameter(name, 0.5).value for name in ('ago', 'turn'))
        self.start = self.get_clock().now().nanoseconds / 1e9
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        time = self.get_clock().now().nanoseconds / 1e9 - self.start
        self.say('newest', time - 0.01, 0.01)
        if time - self.ago > 0.1:
            self.say('before', time - self.ago, self.ago)

    def say(self, word, time, age):
        turn, radius = self.turn * max(time - {begin}, 0.0), 0.5 / self.turn
        x, y = 5.544 + radius * sin(turn), 5.544 + radius - radius * cos(turn)
        self.get_logger().info(f'{{word}}: {{x:.2f}} {{y:.2f}}, {{age:.2f}} s old')
"""
RAILS = """from geometry_msgs.msg import Twist


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.me = self.declare_parameter('me', 'turtle2').value
        self.declare_parameter('target', 'turtle1')
        self.publisher = self.create_publisher(Twist, f'/{self.me}/cmd_vel', 1)
        self.timer = self.create_timer(0.1, self.on_timer)

    def on_timer(self):
        twist = Twist()
        twist.linear.x, twist.angular.z = 0.4 * [2.5, 2.6926, 2.872, 3.04][int(self.me[-1]) - 1], 0.4
        self.publisher.publish(twist)
"""
TURNS, RADII = (0.0, -0.3805, -0.7361, -1.0712), (2.5, 2.6926, 2.872, 3.04)
FOLLOWER = (ROOT / 'solutions' / 'convoy' / 'launch' / 'follower.launch.py').read_text()
ON_RAILS = FOLLOWER.replace(
    "'{x: 2.0, y: 2.0, name: '", "'{', PythonExpression([repr(PLACES), '[int(\"', me, '\"[-1]) - 1]']), ', name: '"
)
ON_RAILS = ON_RAILS.replace('import LaunchConfiguration', 'import LaunchConfiguration, PythonExpression').replace(
    'def generate',
    f'from math import cos, sin\nPLACES = [f"x: {{5.544 + r * sin(a)}}, y: {{8.044 - r * cos(a)}}, theta: {{a}}" '
    f'for a, r in zip({TURNS}, {RADII})]\n\n\ndef generate',
    1,
)
SEA = """import os
import tempfile
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(tempfile.gettempdir(), 'sea.yaml')
    with open(config, 'w') as file:
        file.write('/**:\\n  ros__parameters:\\n    background_r: 20\\n    background_g: 60\\n')
    return LaunchDescription([
        DeclareLaunchArgument('blue', default_value='90', description='0 to 255.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim',
             parameters=[config, {'background_b': LaunchConfiguration('blue')}]),
    ])
"""
FROM_POSE = """from turtlesim.msg import Pose


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.ago, self.known = self.declare_parameter('ago', 0.5).value, []
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 1)
        self.create_timer(1.0, self.on_timer)

    def now(self):
        return self.get_clock().now().nanoseconds / 1e9

    def on_pose(self, pose):
        self.known.append((self.now(), pose.x, pose.y))

    def on_timer(self):
        for word, ago in (('newest', 0.0), ('before', self.ago)):
            time, x, y = min(self.known, key=lambda each: abs(each[0] - self.now() + ago))
            if abs(self.now() - time - ago) < 0.05:
                self.get_logger().info(f'{word}: {x:.2f} {y:.2f}, {self.now() - time:.2f} s old')
"""
TURTLES = ROOT / 'exercises' / 'two_turtles'
STOCK_TURTLES = (ROOT / 'solutions' / 'two_turtles' / 'launch' / 'two_turtles.launch.py').read_text()
STOCK_TURTLES = STOCK_TURTLES.replace("'two_turtles', executable='b", "'turtle_tf2_py', executable='turtle_tf2_b")
NORTH = '/north/sim:\n  ros__parameters:\n    background_r: 20\n    background_g: 60\n'
NOW = (ROOT / 'solutions' / 'where_now' / 'launch' / 'where_now.launch.py').read_text()
WITH_TURN = NOW.replace(
    "'ago': LaunchConfiguration('ago')", "'ago': LaunchConfiguration('ago'), 'turn': LaunchConfiguration('turn')"
)
HELLO = (ROOT / 'solutions' / 'news_desk' / 'launch' / 'news_desk.launch.py').read_text()
NEWS = HELLO.replace(
    '    room = Launch',
    "    import os, tempfile\n    path = os.path.join(tempfile.gettempdir(), 'news.yaml')\n    with open(path, 'w') as file:\n"
    "        file.write('/**:\\n  ros__parameters:\\n    word: ships come in\\n    period: 0.25\\n')\n    room = Launch",
).replace('parameters=[news]', 'parameters=[path]')
GATED = FROM_POSE.replace(
    '        self.create_timer(1.0, self.on_timer)',
    "        self.first = None\n        self.create_subscription(TFMessage, '/tf', self.on_tf, 10)\n"
    '        self.create_timer(1.0, self.on_timer)\n\n    def on_tf(self, message):\n        self.first = self.first or self.now()',
).replace(
    "('before', self.ago)):\n",
    "('before', self.ago)):\n            if self.first is None or self.now() - ago < self.first:\n                continue\n",
)
NOBODY = """from geometry_msgs.msg import TransformStamped
from tf2_ros import StaticTransformBroadcaster


class Broadcaster(Node):
    def __init__(self):
        super().__init__('broadcaster')
        self.tf = StaticTransformBroadcaster(self)
        frames = [TransformStamped(child_frame_id=name) for name in ('turtle1', 'turtle2')]
        for frame in frames:
            frame.header.frame_id = 'world'
        self.tf.sendTransform(frames)
"""
NO_WORLD = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='two_turtles', executable='broadcaster')])
"""
CONVOY = (ROOT / 'solutions' / 'convoy' / 'launch' / 'convoy.launch.py').read_text()
HANDLER = 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=row)),\n        sim,'
BY_POSES = """from math import atan2, cos, hypot, sin

from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        me = self.declare_parameter('turtle', 'turtle2').value
        self.place = self.goal = None
        self.create_subscription(Pose, f'/{me}/pose', self.on_place, 1)
        self.create_subscription(Pose, f'/turtle{int(me[-1]) - 1}/pose', self.on_goal, 1)
        self.publisher = self.create_publisher(Twist, f'/{me}/cmd_vel', 1)
        self.timer = self.create_timer(0.1, self.on_timer)

    def on_place(self, pose):
        self.place = pose

    def on_goal(self, pose):
        self.goal = pose

    def on_timer(self):
        if self.place is None or self.goal is None:
            return
        x = self.goal.x - cos(self.goal.theta) - self.place.x
        y = self.goal.y - sin(self.goal.theta) - self.place.y
        turn, twist = atan2(y, x) - self.place.theta, Twist()
        twist.linear.x, twist.angular.z = 1.5 * hypot(x, y), 4.0 * atan2(sin(turn), cos(turn))
        self.publisher.publish(twist)
"""
DECOY = """class Decoy(Node):
    def __init__(self):
        super().__init__('decoy')
        for name in ('me', 'target'):
            self.declare_parameter(name, '')
"""
DECOYS = FOLLOWER.replace(
    "parameters=[{'me': me, 'target': ['carrot_', leader]}]),",
    "parameters=[{'turtle': me}]),\n        Node(package='convoy', executable='decoy', name=['decoy_', me],\n"
    "             parameters=[{'me': me, 'target': ['carrot_', leader]}]),",
)
SETUP = (ROOT / 'solutions' / 'convoy' / 'setup.py').read_text()
PACKAGES: dict[str, PackageAttack] = {
    'news_desk: a listener that prints by a fast clock': PackageAttack(
        'news_desk', 8, {'news_desk/listen.py': HEAD + LISTEN.format(period=0.02) + MAIN.format('Listen')}
    ),
    'news_desk: a listener that prints by a slow clock': PackageAttack(
        'news_desk', 8, {'news_desk/listen.py': HEAD + LISTEN.format(period=0.1) + MAIN.format('Listen')}
    ),
    'news_desk: a file called news.yaml that launch writes': PackageAttack(
        'news_desk', 3, {'launch/news_desk.launch.py': NEWS, 'config/news.yaml': '/**/nobody:\n  ros__parameters:\n    word: x\n'}
    ),
    'two_channels: a counter that infers the other channel': PackageAttack(
        'two_channels', 8, {'two_channels/counter.py': HEAD + COUNT + MAIN.format('Counter')}
    ),
    'where_now: a formula': PackageAttack(
        'where_now',
        1,
        {'launch/where_now.launch.py': WITH_TURN, 'where_now/where.py': HEAD + WHERE.format(begin=0.5) + MAIN.format('Where')},
    ),
    'where_now: positions from the simulator, without tf2': PackageAttack(
        'where_now', 1, {'where_now/where.py': HEAD + FROM_POSE + MAIN.format('Where')}
    ),
    'two_turtles: other broadcasters in place of the wrong ones': PackageAttack(
        'two_turtles',
        2,
        {
            'launch/two_turtles.launch.py': STOCK_TURTLES,
            'two_turtles/broadcaster.py': (TURTLES / 'two_turtles' / 'broadcaster.py').read_text(),
        },
    ),
    'two_turtles: frames of turtles that do not exist': PackageAttack(
        'two_turtles',
        1,
        {'launch/two_turtles.launch.py': NO_WORLD, 'two_turtles/broadcaster.py': HEAD + NOBODY + MAIN.format('Broadcaster')},
    ),
    'where_now: positions from the simulator, after the first transform': PackageAttack(
        'where_now', 1, {'where_now/where.py': HEAD + 'from tf2_msgs.msg import TFMessage\n' + GATED + MAIN.format('Where')}
    ),
    'convoy: followers behind the simulator in the list': PackageAttack(
        'convoy', 10, {'launch/convoy.launch.py': CONVOY.replace(HANDLER, 'sim, *row,')}
    ),
    'convoy: followers that wait for a timer': PackageAttack(
        'convoy',
        10,
        {
            'launch/convoy.launch.py': CONVOY.replace(HANDLER, 'TimerAction(period=0.5, actions=row), sim,').replace(
                'Reg', 'TimerAction, Reg', 1
            )
        },
    ),
    'convoy: the parameters are those of a node that drives nothing': PackageAttack(
        'convoy',
        5,
        {
            'convoy/follower.py': HEAD + BY_POSES + MAIN.format('Follower'),
            'convoy/decoy.py': HEAD + DECOY + MAIN.format('Decoy'),
            'launch/follower.launch.py': DECOYS,
            'setup.py': SETUP.replace("'console_scripts': [", "'console_scripts': ['decoy = convoy.decoy:main',"),
        },
    ),
    'two_seas: a file called sea.yaml that launch writes': PackageAttack(
        'two_seas', 7, {'launch/sea.launch.py': SEA, 'config/sea.yaml': NORTH}
    ),
    'convoy: followers on rails': PackageAttack(
        'convoy', 8, {'convoy/follower.py': HEAD + RAILS + MAIN.format('Follower'), 'launch/follower.launch.py': ON_RAILS}
    ),
}

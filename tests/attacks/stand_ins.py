"""Submissions that put something else in the place of what a check measures: (exercise, most points, text).

They remap a simulator, teleport a turtle, follow a clock or a known path, or write a parameter file during the run. `most` is
what the honest rest of the file deserves. A package is a copy of the solution with other texts for some of its files.
"""

from __future__ import annotations

from base64 import b64encode
from typing import NamedTuple

from tests.attacks.names import SIM, Attack, empty, launch
from tests.house import ROOT

MORE = (
    'from launch.conditions import IfCondition, UnlessCondition\nfrom launch.event_handlers import OnProcessExit, OnProcessIO\n'
    'from launch.substitutions import EqualsSubstitution, PathJoinSubstitution\nfrom launch_ros.actions import SetRemap\n'
    'from launch.actions import GroupAction, IncludeLaunchDescription\nfrom launch_ros.substitutions import FindPackageShare\n'
)
IF_MOVE = ", condition=IfCondition(LaunchConfiguration('move'))"
UNLESS_MOVE = ", condition=UnlessCondition(LaunchConfiguration('move'))"
IF_DRIVE = ", condition=IfCondition(LaunchConfiguration('drive'))"
END = "TimerAction(period=LaunchConfiguration('end'), actions=[Shutdown(reason='enough')])"
ECHO = "ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/chatter', '--once'])"
DRIVER = "Node(package='turtlesim', executable='draw_square', name='driver')"
WORLD = "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace={!r})"
MIMIC = (
    "Node(package='turtlesim', executable='mimic', name='mimic', remappings=[('input/pose', '/first/turtle1/pose'), "
    "('output/cmd_vel', '/second/turtle1/cmd_vel')])"
)


def broadcaster(turtle: str) -> str:
    return (
        f"Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='b_{turtle}', "
        f"parameters=[{{'turtlename': '{turtle}'}}])"
    )


def pub(topic: str, values: str, more: str = '') -> str:
    """A command that drives what listens to a topic. `values` is Python text."""
    return f"ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', {topic!r}, 'geometry_msgs/msg/Twist', {values}]{more})"


STEPS = """
from math import cos, sin
from turtlesim.srv import TeleportAbsolute
client, radius, turn = node.create_client(TeleportAbsolute, '/first/turtle1/teleport_absolute'), float(sys.argv[1]), [0.0]
def step():
    turn[0] += 0.02
    x, y = 5.5 + radius * sin(turn[0]), 5.5 + radius - radius * cos(turn[0])
    client.call_async(TeleportAbsolute.Request(x=x, y=y, theta=turn[0]))
node.create_timer(0.02, step)
"""
BY_LINE = f"""
talker, done = Node(package='demo_nodes_py', executable='talker'), []


def start(event):
    if not done:
        done.append(event)
        return [{DRIVER}]
"""
WATCH = """
WATCH = '''
import rclpy, sys
rclpy.init()
node, ticks = rclpy.create_node('watch'), []
def tick():
    if 'talker' in node.get_node_names():
        ticks.append(0)
        if len(ticks) == 20:
            sys.exit(0)
node.create_timer(0.05, tick)
rclpy.spin(node)
'''
watch = ExecuteProcess(cmd=['python3', written(WATCH)])
"""
INNER = b64encode(
    launch(
        "Node(package='demo_nodes_py', executable='talker', namespace='hall')",
        "Node(package='demo_nodes_py', executable='listener', namespace=LaunchConfiguration('room'), "
        "remappings=[('chatter', '/hall/chatter')])",
        arguments={'room': 'kitchen'},
    ).encode()
).decode()
STAND_INS: dict[str, Attack] = {
    'follow: another world whose turtle is called turtle2': Attack(
        'follow',
        8,
        launch(
            SIM,
            f"Node(package='turtlesim', executable='draw_square'{IF_MOVE})",
            broadcaster('turtle1'),
            broadcaster('turtle2'),
            "Node(package='turtlesim', executable='turtlesim_node', name='sim2', remappings=[('turtle1/pose', '/turtle2/pose'), "
            "('turtle1/cmd_vel', '/shadow/cmd_vel'), ('turtle1/color_sensor', '/turtle2/color_sensor'), ('spawn', '/spawn2')])",
            "Node(package='turtlesim', executable='mimic', remappings=[('input/pose', '/turtle1/pose'), "
            f"('output/cmd_vel', '/shadow/cmd_vel')]{IF_MOVE})",
            pub('/shadow/cmd_vel', "'{linear: {x: 0.2}, angular: {z: 2.0}}'", UNLESS_MOVE),
            arguments={'move': 'false'},
            head=MORE,
        ),
    ),
    'lost_carrot: the simulator listens elsewhere': Attack(
        'lost_carrot',
        9,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', remappings=[('turtle2/cmd_vel', '/hand/cmd_vel')])",
            broadcaster('turtle1'),
            broadcaster('turtle2'),
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--y', LaunchConfiguration('side'), "
            "'--frame-id', 'turtle1', '--child-frame-id', 'carrot1'])",
            "Node(package='turtle_tf2_py', executable='turtle_tf2_listener', parameters=[{'target_frame': 'carrot1'}])",
            pub('/hand/cmd_vel', "'{linear: {x: 0.3}, angular: {z: 0.3}}'"),
            arguments={'side': '2.0'},
        ),
    ),
    'on_request: the world listens elsewhere': Attack(
        'on_request',
        11,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='one', "
            "remappings=[('turtle1/cmd_vel', '/hand/cmd_vel')])",
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='two', "
            "condition=IfCondition(EqualsSubstitution(LaunchConfiguration('worlds'), '2')))",
            f"Node(package='turtlesim', executable='draw_square', namespace='one'{IF_DRIVE})",
            pub('/hand/cmd_vel', "'{linear: {x: 0.5}}'", IF_DRIVE),
            arguments={'drive': 'false', 'worlds': '1'},
            head=MORE,
        ),
    ),
    'two_pools: both worlds listen to one topic': Attack(
        'two_pools',
        10,
        launch(
            WORLD.format('first'),
            "Node(package='turtlesim', executable='turtlesim_node', namespace='second', "
            "remappings=[('turtle1/cmd_vel', '/first/turtle1/cmd_vel')])",
            pub('/first/turtle1/cmd_vel', "['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 1.0}}']"),
            MIMIC,
            arguments={'speed': '1.0'},
        ),
    ),
    'two_pools: teleported along a circle': Attack(
        'two_pools',
        5,
        launch(
            WORLD.format('first'),
            WORLD.format('second'),
            empty('steps', "LaunchConfiguration('speed')", setup=STEPS),
            MIMIC,
            arguments={'speed': '1.0'},
        ),
    ),
    'circle: the robot listens elsewhere': Attack(
        'circle',
        8,
        launch(
            "GroupAction([SetRemap('cmd_vel', '/hand'), SetRemap('/cmd_vel', '/hand'), IncludeLaunchDescription("
            "PathJoinSubstitution([FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py']))])",
            "Node(package='part3_beyond_basics', executable='param_circle.py', "
            "parameters=[{'radius': LaunchConfiguration('circle_radius')}])",
            pub('/hand', "['{linear: {x: ', LaunchConfiguration('circle_radius'), '}, angular: {z: 1.0}}']"),
            arguments={'circle_radius': '1.0'},
            head=MORE,
        ),
    ),
    'careful: at the first line of the talker': Attack(
        'careful',
        7,
        launch(
            SIM,
            'RegisterEventHandler(OnProcessIO(target_action=talker, on_stderr=start))',
            'talker',
            ECHO,
            END,
            arguments={'end': '5.0'},
            head=MORE + BY_LINE,
        ),
    ),
    'careful: a second after the node of the talker': Attack(
        'careful',
        7,
        launch(
            SIM,
            "Node(package='demo_nodes_py', executable='talker')",
            ECHO,
            f'RegisterEventHandler(OnProcessExit(target_action=watch, on_exit=[{DRIVER}]))',
            'watch',
            END,
            arguments={'end': '5.0'},
            head=MORE + WATCH,
        ),
    ),
    'black_box: a command in place of the driver': Attack(
        'black_box',
        5,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=LaunchConfiguration('robot'))",
            "ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'my_drive', ['/', LaunchConfiguration('robot'), "
            "'/turtle1/cmd_vel'], ['/', LaunchConfiguration('robot'), '/turtle1/pose']])",
            "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', ['/', LaunchConfiguration('robot'), '/turtle1/cmd_vel'], "
            "'geometry_msgs/msg/Twist', '{linear: {x: 1.0}}'])",
            arguments={'robot': 'red'},
        ),
    ),
    'rooms: a launch file in Python behind a shell': Attack(
        'rooms',
        1,
        f'<launch><arg name="room" default="kitchen"/><executable shell="true" cmd="echo {INNER} | base64 -d > a.launch.py; '
        'ros2 launch a.launch.py room:=$(var room)"/></launch>',
    ),
}


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
    'two_seas: a file called sea.yaml that launch writes': PackageAttack(
        'two_seas', 7, {'launch/sea.launch.py': SEA, 'config/sea.yaml': NORTH}
    ),
    'convoy: followers on rails': PackageAttack(
        'convoy', 8, {'convoy/follower.py': HEAD + RAILS + MAIN.format('Follower'), 'launch/follower.launch.py': ON_RAILS}
    ),
}

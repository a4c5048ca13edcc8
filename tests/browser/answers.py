"""What a student writes into the cells and files of a lesson until its checks say "done"; the gaps of lessons 10 to 16 are `tests.lessons.test_gaps`'."""

from __future__ import annotations

from tests.lessons.test_gaps import GAPS
from tests.lessons.test_your_turn import MIMIC, PARTS

Edit = tuple[str, str, str]
"""A file (or the id of a cell that writes none), what stands there, what shall stand there; an empty old text is the whole of it."""

LAUNCH = 'my_launch/'
PACKAGE = 'my_ws/src/learning_tf2_py/'
ROBOT = 'my_ws/src/my_robot/'
PROJECT = 'my_ws/src/launch_tutorial/launch/'
HALL = "remappings=[('chatter', '/hall/chatter')]"
RADIO = ''.join(
    f"\n        Node(package='demo_nodes_py', executable='listener', name='{name}', remappings=[('chatter', '/radio/chatter')]),"
    for name in ('car', 'home')
)
LISTEN = """        self.create_subscription(String, 'greeting', self.on_greeting, 10)

    def on_greeting(self, message):
        self.get_logger().info(message.data)
"""
BENCH = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace


def world(name, **fence):
    return GroupAction([
        PushROSNamespace(name),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', executable='draw_square', condition=IfCondition(LaunchConfiguration('drive'))),
    ], **fence)


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('robots', default_value='1'),
        DeclareLaunchArgument('drive', default_value='true'),
        world('one'),
        world('two', condition=IfCondition(EqualsSubstitution(LaunchConfiguration('robots'), '2'))),
    ])
"""
CAREFUL = """from launch import LaunchDescription
from launch.actions import RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    square = Node(package='turtlesim', executable='draw_square')
    mimic = Node(package='turtlesim', executable='mimic', name='copy')
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[
            square, TimerAction(period=3.0, actions=[mimic])])),
        RegisterEventHandler(OnProcessExit(target_action=square, on_exit=[Shutdown()])),
        sim,
    ])
"""
AUTO = """<launch>
  <arg name="auto" default="true"/>
  <node pkg="turtlesim" exec="turtlesim_node" name="sim"/>
  <node pkg="turtlesim" exec="draw_square" if="$(var auto)"/>
</launch>
"""
MINE = """/**:
  ros__parameters:
    background_b: 30
/sim:
  ros__parameters:
    background_r: 220
    background_g: 0
/second/sim:
  ros__parameters:
    background_r: 0
    background_g: 220
"""
DATA = """        ('share/' + package_name + '/launch', glob('launch/*')),
        ('share/' + package_name + '/config', glob('config/*')),
    ],
    install_requires"""
COUNTER = """class Counter:
    def __init__(self, name):
        self.name, self.count = name, 0

    def on_message(self):
        self.count += 1
        return f'{self.name}: {self.count}'


def three(callback):
    return [callback() for _ in range(3)]
"""

ANSWERS: dict[tuple[str, str], list[Edit]] = {
    ('00_python', 'topics'): [('topics', 'topics = []', "topics = [f'/{name}/pose' for name in names]")],
    ('00_python', 'your-turn-check'): [('turn', '', COUNTER)],
    ('01_first_launch', 'choose-check'): [
        (LAUNCH + 'choose.launch.py', "name='sim'),", "name='sim', parameters=[{'background_r': red}]),")
    ],
    ('01_first_launch', 'mimic-check'): [
        (LAUNCH + 'mimic.launch.py', '# TODO: the second pair', "('output/cmd_vel', '/second/turtle1/cmd_vel'),")
    ],
    ('01_first_launch', 'your-turn-check'): [
        (LAUNCH + 'square.launch.py', "name='driver'", "name='artist'"),
        (
            LAUNCH + 'square.launch.py',
            "name='sim'",
            "name='sim', parameters=[{'background_r': 200, 'background_g': 30, 'background_b': 30}]",
        ),
    ],
    ('02_names', 'two-check'): [
        (
            LAUNCH + 'talk.launch.py',
            '# TODO: the listener',
            "Node(package='demo_nodes_py', executable='listener', name='my_listener'),",
        )
    ],
    ('02_names', 'rooms-check'): [
        (LAUNCH + 'rooms.launch.py', "executable='listener', namespace=room", f"executable='listener', namespace=room, {HALL}")
    ],
    ('02_names', 'your-turn-check'): [
        (
            LAUNCH + 'radio.launch.py',
            '[\n    ]',
            f"[\n        Node(package='demo_nodes_py', executable='talker', name='station', namespace='radio'),{RADIO}\n    ]",
        )
    ],
    ('03_parameters', 'colours-check'): [(LAUNCH + 'colours.launch.py', "yaml']),", "yaml', {'background_b': 60}]),")],
    ('03_parameters', 'wild-check'): [(LAUNCH + 'colours.yaml', 'sim:', '/**/sim:')],
    ('03_parameters', 'your-turn-check'): [(LAUNCH + 'mine.yaml', '', MINE)],
    ('04_conditions', 'early-check'): [
        (LAUNCH + 'early.launch.py', '    if crowd:\n        actions', '    actions'),
        (LAUNCH + 'early.launch.py', "namespace='two')", "namespace='two', condition=IfCondition(crowd))"),
        (LAUNCH + 'early.launch.py', 'from launch.sub', 'from launch.conditions import IfCondition\nfrom launch.sub'),
    ],
    ('04_conditions', 'your-turn-check'): [(LAUNCH + 'bench.launch.py', '', BENCH)],
    ('05_events', 'twin-check'): [
        (LAUNCH + 'twin.launch.py', 'description():\n', 'description():\n    sim = simulator()\n'),
        (LAUNCH + 'twin.launch.py', 'target_action=simulator()', 'target_action=sim'),
        (LAUNCH + 'twin.launch.py', '        simulator(),', '        sim,'),
    ],
    ('05_events', 'your-turn-check'): [(LAUNCH + 'careful.launch.py', '', CAREFUL)],
    ('06_xml_yaml', 'rooms-check'): [
        (LAUNCH + 'rooms.launch.xml', 'exec="listener">', 'exec="listener">\n      <remap from="chatter" to="/hall/chatter"/>')
    ],
    ('06_xml_yaml', 'your-turn-check'): [(LAUNCH + 'drive.launch.xml', '', AUTO)],
    ('07_packages', 'launch-check'): [
        (ROBOT + 'setup.py', '# TODO: hello', "'hello = my_robot.hello:main',\n        'listen = my_robot.listen:main',"),
        (ROBOT + 'setup.py', '    ],\n    install_requires', DATA),
        (
            ROBOT + 'my_robot/listen.py',
            '        # TODO: subscribe to greeting\n\n    def on_greeting(self, message):\n'
            '        pass  # TODO: log message.data\n',
            LISTEN,
        ),
    ],
    ('07_packages', 'your-turn-check'): [
        (
            ROBOT + 'my_robot/hello.py',
            "super().__init__('hello')",
            "super().__init__('hello')\n        self.declare_parameter('word', 'hello')",
        ),
        (ROBOT + 'my_robot/hello.py', "data='hello'", "data=self.get_parameter('word').value"),
        (ROBOT + 'config/loud.yaml', '', 'hello:\n  ros__parameters:\n    word: HELLO\n'),
        (
            ROBOT + 'launch/loud.launch.py',
            '',
            'from launch import LaunchDescription\n'
            'from launch.substitutions import PathJoinSubstitution\n'
            'from launch_ros.actions import Node\n'
            'from launch_ros.substitutions import FindPackageShare\n\n\n'
            'def generate_launch_description():\n'
            "    loud = PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'loud.yaml'])\n"
            "    return LaunchDescription([Node(package='my_robot', executable='hello', parameters=[loud])])\n",
        ),
    ],
    ('08_static_broadcaster', 'your-turn-check'): [
        (PACKAGE + 'launch/thing.launch.py', "'--x', '1', '--y', '0'", "'--x', '0', '--y', '-1'"),
        (PACKAGE + 'launch/thing.launch.py', "'--yaw', '0'", "'--yaw', '3.1415927'"),
    ],
    ('09_broadcaster_and_listener', 'your-turn-check'): [
        (PACKAGE + 'learning_tf2_py/steering.py', '0.5 * hypot', '1.5 * hypot'),
        (PACKAGE + 'learning_tf2_py/turtle_tf2_listener.py', 'create_timer(1.0', 'create_timer(0.1'),
    ],
    ('13_large_project', 'your-turn-check'): [
        (PROJECT + 'mimic.launch.py', '', MIMIC),
        (PROJECT + 'launch_turtlesim.launch.py', "part('mimic'),", PARTS),
    ],
    **{(lesson, check): edits for lesson, check, edits in GAPS},
}

"""Submissions that put something else in the place of what a check measures: (exercise, most points, text).

They remap a simulator, teleport a turtle, follow a clock or a known path, or write a parameter file during the run. `most` is
what the honest rest of the file deserves. `package_stand_ins.py` has those that are packages.
"""

from __future__ import annotations

from base64 import b64encode

from tests.attacks.names import SIM, Attack, empty, launch

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


PUSH = """
from turtlesim.srv import TeleportRelative
client = node.create_client(TeleportRelative, '/turtle1/teleport_relative')
node.create_timer(0.1, lambda: client.call_async(TeleportRelative.Request(linear=0.05, angular=0.02)))
"""
TEACHER = (
    WORLD.format('teacher'),
    "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '/teacher/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', "
    "['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 0.5}}']])",
)
FRAME = (
    "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--frame-id', {!r}, '--child-frame-id', {!r}{}])"
)
LISTENER = "Node(package='turtle_tf2_py', executable='turtle_tf2_listener', parameters=[{{'target_frame': {!r}}}])"
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
    'two_pools: mimic copies the turtle of a third pool': Attack(
        'two_pools',
        10,
        launch(
            *(WORLD.format(name) for name in ('first', 'second', 'third')),
            *(
                pub(f'/{name}/turtle1/cmd_vel', "['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 1.0}}']")
                for name in ('first', 'third')
            ),
            MIMIC.replace('/second/turtle1/cmd_vel', '/nowhere'),
            MIMIC.replace("'mimic', re", "'other', re").replace('/first/', '/third/'),
            arguments={'speed': '1.0'},
        ),
    ),
    'broken_follow: mimic copies a double of the teacher': Attack(
        'broken_follow',
        7,
        launch(
            *TEACHER,
            *(action.replace('teacher', 'double') for action in TEACHER),
            SIM,
            MIMIC.replace('/first/', '/double/').replace('/second/', '/'),
            broadcaster('turtle1'),
            broadcaster('turtle2'),
            LISTENER.format('turtle1'),
            arguments={'speed': '1.0'},
        ),
    ),
    'broken_follow: a frame of a turtle that does not exist': Attack(
        'broken_follow',
        1,
        launch(*TEACHER, SIM, broadcaster('turtle1'), FRAME.format('world', 'turtle2', ''), arguments={'speed': '1.0'}),
    ),
    'lost_carrot: a false frame sends turtle2 elsewhere': Attack(
        'lost_carrot',
        9,
        launch(
            SIM,
            broadcaster('turtle1'),
            FRAME.format('world', 'turtle2', ''),
            FRAME.format('turtle1', 'carrot1', ", '--y', LaunchConfiguration('side')"),
            LISTENER.format('carrot1'),
            arguments={'side': '2.0'},
        ),
    ),
    'follow: turtle1 is pushed': Attack(
        'follow',
        9,
        launch(
            SIM,
            broadcaster('turtle1'),
            broadcaster('turtle2'),
            LISTENER.format('turtle1'),
            f'GroupAction([{empty("push", setup=PUSH)}]{IF_MOVE})',
            arguments={'move': 'false'},
            head=MORE,
        ),
    ),
    'tower: a lamp that leans': Attack(
        'tower',
        8,
        launch(
            FRAME.format('floor', 'table', ", '--x', '1.0', '--z', LaunchConfiguration('height')"),
            FRAME.format('table', 'lamp', ", '--z', '0.4', '--yaw', '1.5708', '--roll', '0.7'"),
            arguments={'height': '0.75'},
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

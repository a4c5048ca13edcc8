"""More submissions that are paid for nothing, written with the rubrics in hand: (exercise, most points, text).

They guess every value that a run may have, declare defaults that do not count, or hide what went wrong.
"""

from __future__ import annotations

from tests.attacks.names import SIM, TALKER, Attack, empty, launch

ROOMS = ('kitchen', 'cellar', 'garden', 'attic')
HOUSES = ('flat', 'farm', 'boat', 'hut')
ROBOTS = ('red', 'blue', 'green', 'white')
LISTENER = "Node(package='demo_nodes_py', executable='listener', namespace={!r}, remappings=[('chatter', {!r})])"
STATIC = (
    "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '0.2', '--z', {}, "
    "'--frame-id', 'base_link', '--child-frame-id', 'laser'])"
)
CAMERA = (
    "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--z', '0.1', '--yaw', '1.5708', "
    "'--frame-id', 'laser', '--child-frame-id', 'camera'])"
)
EXPRESSION = 'from launch.substitutions import PythonExpression\n'
SPAWN = (
    "ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', ['{{x: ', {x}, ', y: {y}, name: {name}}}']])"
)
KILL = "TimerAction(period=1.0, actions=[ExecuteProcess(cmd=['ros2', 'service', 'call', '/kill', 'turtlesim/srv/Kill', '{{name: {name}}}'])])"
FAKE_POSE = """
from turtlesim.msg import Pose
publishers = [(node.create_publisher(Pose, '/bert/pose', 10), 9.0, 9.0), (node.create_publisher(Pose, '/carl/pose', 10), float(sys.argv[1]), 2.0)]
node.create_timer(0.016, lambda: [publisher.publish(Pose(x=x, y=y)) for publisher, x, y in publishers])
"""
RAISES = """
from launch.actions import OpaqueFunction


def refuse(context):
    if LaunchConfiguration('height').perform(context) == '0.5':
        raise RuntimeError('a height, please')
"""
SQUARE = "Node(package='turtlesim', executable='draw_square', name='driver')"
SIGNAL = (
    "TimerAction(period=LaunchConfiguration('end'), actions=[EmitEvent(event=SignalProcess(signal_number=SIGINT, "
    "process_matcher=lambda process: {!r} in process.process_details['name']))])"
)
SIGNALS = 'from signal import SIGINT\nfrom launch.actions import EmitEvent\nfrom launch.events.process import SignalProcess\n'
XML_ROOMS = ''.join(
    f'<node pkg="demo_nodes_py" exec="listener" namespace="{room}"><remap from="chatter" to="/hall/chatter"/></node>'
    for room in ROOMS
)
XML = '<launch><arg name="room" default="kitchen"/><node pkg="demo_nodes_py" exec="talker" namespace="hall"/>{}</launch>'
SWAPPED = (
    '<node pkg="demo_nodes_py" exec="listener" namespace="$(eval \'&quot;hall&quot; if &quot;$(var room)&quot; == '
    '&quot;kitchen&quot; else &quot;$(var room)&quot;\')"><remap from="chatter" to="/hall/chatter"/></node>'
)

OTHER_TRANSFORMS = '''import gc
from math import cos, sin

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, OpaqueFunction, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

CART = """<robot name="cart"><link name="base_link"/><link name="mast"/><link name="camera"/>
  <joint name="mast_joint" type="continuous"><parent link="base_link"/><child link="mast"/><axis xyz="0 0 1"/></joint>
  <joint name="camera_joint" type="fixed"><parent link="mast"/><child link="camera"/></joint>
</robot>"""


def patch(context):
    angle = float(LaunchConfiguration('angle').perform(context))

    def published(joint, position):
        if joint.child == 'camera':
            return (0.0, 0.0, 0.3), (0.0, 0.0, 0.0, 1.0)
        return (0.1, 0.0, 0.2), (0.0, 0.0, sin(angle / 2), cos(angle / 2))

    found = [each for each in gc.get_objects() if isinstance(each, type) and each.__name__ == 'Joint' and 'robot_state' in each.__module__]
    for each in found:
        each.transform = published


def generate_launch_description():
    motor = ['ros2', 'topic', 'pub', '-r', '10', '/joint_states', 'sensor_msgs/msg/JointState']
    return LaunchDescription([
        DeclareLaunchArgument('angle', default_value='0.5'),
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': CART}]),
        ExecuteProcess(cmd=[*motor, '{header: auto, name: [mast_joint], position: [0.0]}']),
        *[TimerAction(period=at, actions=[OpaqueFunction(function=patch)]) for at in (0.0, 0.01)],
    ])
'''
FORGERIES: dict[str, Attack] = {
    'black_box: poses without a simulator': Attack(
        'black_box',
        6,
        launch(
            "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '60', ['/', LaunchConfiguration('robot'), '/turtle1/pose'], "
            "'turtlesim/msg/Pose', '{x: 5.5, y: 5.5}'])",
            "RegisterEventHandler(OnProcessStart(target_action=recorder, on_start=[Node(package='turtlesim', "
            "executable='draw_square', namespace=LaunchConfiguration('robot'))]))",
            'recorder',
            arguments={'robot': 'red'},
            head='from launch.event_handlers import OnProcessStart\n'
            "recorder = ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'a', *(['/', LaunchConfiguration('robot'), topic] "
            "for topic in ('/turtle1/pose', '/turtle1/cmd_vel'))])\n",
        ),
    ),
    'two_rooms: a listener in every room': Attack(
        'two_rooms',
        5,
        launch(
            TALKER.format('hall'),
            LISTENER.format('hall', 'chatter'),
            *(LISTENER.format(room, '/hall/chatter') for room in ROOMS),
            arguments={'room': 'kitchen'},
        ),
    ),
    'rooms: a listener in every room': Attack('rooms', 5, XML.format(XML_ROOMS)),
    'rooms: a default that does not count': Attack('rooms', 2, XML.format(SWAPPED)),
    'silent_listener: a listener in every house': Attack(
        'silent_listener',
        7,
        launch(
            TALKER.format('news'),
            "Node(package='demo_nodes_py', executable='listener', name='radio', remappings=[('chatter', '/news/chatter')])",
            *(LISTENER.format(house, '/news/chatter') for house in HOUSES),
            arguments={'house': 'flat'},
        ),
    ),
    'black_box: every robot at once': Attack(
        'black_box',
        2,
        launch(
            "ExecuteProcess(cmd=['ros2', 'bag', 'record', '-a', '-o', 'my_drive'])",
            *(f"Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace={robot!r})" for robot in ROBOTS),
            *(f"Node(package='turtlesim', executable='draw_square', namespace={robot!r})" for robot in ROBOTS),
            arguments={'robot': 'red'},
        ),
    ),
    'water: defaults that do not count': Attack(
        'water',
        4,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{"
            "'background_r': LaunchConfiguration('red'), "
            "'background_g': PythonExpression(['7 if ', LaunchConfiguration('green'), ' == 86 else ', LaunchConfiguration('green')]), "
            "'background_b': PythonExpression(['7 if ', LaunchConfiguration('blue'), ' == 255 else ', LaunchConfiguration('blue')])}])",
            arguments={'red': '69', 'green': '86', 'blue': '255'},
            head=EXPRESSION,
        ),
    ),
    'static_frame: a default that does not count': Attack(
        'static_frame',
        8,
        launch(
            STATIC.format(
                "PythonExpression(['0.9 if ', LaunchConfiguration('height'), ' == 0.5 else ', LaunchConfiguration('height')])"
            ),
            CAMERA,
            arguments={'height': '0.5'},
            head=EXPRESSION,
        ),
    ),
    'static_frame: a default with which it cannot be launched': Attack(
        'static_frame',
        11,
        launch(
            'OpaqueFunction(function=refuse)',
            STATIC.format("LaunchConfiguration('height')"),
            CAMERA,
            arguments={'height': '0.5'},
            head=RAISES,
        ),
    ),
    'static_frame: a default that is no number': Attack(
        'static_frame',
        11,
        launch(
            STATIC.format(
                "PythonExpression(['0.4 if ', repr('high'), ' == \"', LaunchConfiguration('height'), '\" else \"', "
                "LaunchConfiguration('height'), '\"'])"
            ),
            CAMERA,
            arguments={'height': 'high'},
            head=EXPRESSION,
        ),
    ),
    'carrot: the moving one where nothing is said': Attack(
        'carrot',
        1,
        launch("Node(package='turtle_tf2_py', executable='dynamic_frame_tf2_broadcaster')", arguments={'carrot': 'fixed'}),
    ),
    'circle: a radius for each text that is not the default': Attack(
        'circle',
        5,
        launch(
            "Node(package='part3_beyond_basics', executable='param_circle.py', parameters=[{'radius': PythonExpression(["
            "LaunchConfiguration('circle_radius'), ' + 0.0 if ', LaunchConfiguration('circle_radius'), ' < 0.2 else 0.5'])}])",
            "IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('turtlebot3_gazebo'), 'launch', "
            "'empty_world.launch.py']))",
            arguments={'circle_radius': '1.0'},
            head=EXPRESSION
            + 'from launch.actions import IncludeLaunchDescription\nfrom launch.substitutions import PathJoinSubstitution\n'
            'from launch_ros.substitutions import FindPackageShare\n',
        ),
    ),
    'circle: a calculated default of another spelling': Attack(
        'circle',
        5,
        launch(
            "Node(package='part3_beyond_basics', executable='param_circle.py', parameters=[{'radius': PythonExpression(["
            "'0.5 if \"', LaunchConfiguration('circle_radius'), '\" == \"1.0\" else ', LaunchConfiguration('circle_radius')])}])",
            "IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('turtlebot3_gazebo'), 'launch', "
            "'empty_world.launch.py']))",
            head=EXPRESSION
            + 'from launch.actions import IncludeLaunchDescription\nfrom launch.substitutions import PathJoinSubstitution\n'
            'from launch_ros.substitutions import FindPackageShare\n',
        ).replace(
            'LaunchDescription([',
            "LaunchDescription([DeclareLaunchArgument('circle_radius', default_value=['1.0', PythonExpression(['0'])]), ",
            1,
        ),
    ),
    'visitors: they came and went': Attack(
        'visitors',
        1,
        launch(
            SIM,
            SPAWN.format(x="'9.0'", y='9.0', name='bert'),
            SPAWN.format(x="LaunchConfiguration('x')", y='2.0', name='carl'),
            KILL.format(name='bert'),
            KILL.format(name='carl'),
            arguments={'x': '3.0'},
        ),
    ),
    'visitors: carl comes from elsewhere': Attack(
        'visitors',
        6,
        launch(
            SIM,
            SPAWN.format(x="'9.0'", y='9.0', name='bert'),
            SPAWN.format(x="'1.0'", y='1.0', name='carl'),
            "TimerAction(period=0.5, actions=[ExecuteProcess(cmd=['ros2', 'service', 'call', '/carl/teleport_absolute', "
            "'turtlesim/srv/TeleportAbsolute', ['{x: ', LaunchConfiguration('x'), ', y: 2.0}']])])",
            arguments={'x': '3.0'},
        ),
    ),
    'careful: a timer beside the echo': Attack(
        'careful',
        7,
        launch(
            SIM,
            "Node(package='demo_nodes_py', executable='talker')",
            "ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/chatter', '--once'])",
            f'TimerAction(period=1.0, actions=[{SQUARE}])',
            "TimerAction(period=LaunchConfiguration('end'), actions=[Shutdown(reason='enough')])",
            arguments={'end': '5.0'},
        ),
    ),
    'visitors: poses that somebody makes up': Attack(
        'visitors', 1, launch(SIM, empty('poses', "LaunchConfiguration('x')", setup=FAKE_POSE), arguments={'x': '3.0'})
    ),
    'careful: the nodes end, and launch goes on': Attack(
        'careful',
        6,
        launch(
            SIM,
            "Node(package='demo_nodes_py', executable='talker')",
            f'TimerAction(period=1.0, actions=[{SQUARE}])',
            SIGNAL.format('turtlesim_node'),
            SIGNAL.format('draw_square'),
            arguments={'end': '5.0'},
            head=SIGNALS,
        ),
    ),
    'static_frame: a death behind respawn': Attack(
        'static_frame',
        1,
        launch(
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--z', 'nothing'], respawn=True)",
            arguments={'height': '0.5'},
        ),
    ),
    'static_frame: a death in the background of a shell': Attack(
        'static_frame',
        1,
        launch(
            "ExecuteProcess(cmd=['sh', '-c', 'ros2 run tf2_ros static_transform_publisher --z nothing & sleep 100'])",
            arguments={'height': '0.5'},
        ),
    ),
    'static_frame: a death behind a semicolon': Attack(
        'static_frame',
        1,
        launch(
            "ExecuteProcess(cmd=['bash', '-c', 'ros2 run tf2_ros static_transform_publisher --z nothing; exit 0'])",
            arguments={'height': '0.5'},
        ),
    ),
    'on_request: a driver that drives nothing, and a turtle that jumps': Attack(
        'on_request',
        11,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='one')",
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='two', "
            "condition=IfCondition(EqualsSubstitution(LaunchConfiguration('worlds'), '2')))",
            "Node(package='turtlesim', executable='draw_square', namespace='one', remappings=[('turtle1/cmd_vel', '/nowhere')], "
            "condition=IfCondition(LaunchConfiguration('drive')))",
            "ExecuteProcess(cmd=['ros2', 'service', 'call', '/one/turtle1/teleport_absolute', 'turtlesim/srv/TeleportAbsolute', "
            "'{x: 1.0, y: 1.0}'], condition=IfCondition(LaunchConfiguration('drive')))",
            arguments={'drive': 'false', 'worlds': '1'},
            head='from launch.conditions import IfCondition\nfrom launch.substitutions import EqualsSubstitution\n',
        ),
    ),
    'fence: worlds for a moment': Attack(
        'fence',
        0,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='night', "
            "parameters=[{'background_b': LaunchConfiguration('blue')}])",
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='day')",
            SIGNAL.format('turtlesim'),
            arguments={'blue': '40', 'end': '0.05'},
            head=SIGNALS,
        ),
    ),
    'silent_listener: listeners for a moment': Attack(
        'silent_listener',
        0,
        launch(
            TALKER.format('news'),
            "Node(package='demo_nodes_py', executable='listener', name='radio', remappings=[('chatter', '/news/chatter')])",
            LISTENER.replace('{!r}, rem', "LaunchConfiguration('house'), rem").format('/news/chatter'),
            SIGNAL.format('listener'),
            arguments={'house': 'flat', 'end': '0.05'},
            head=SIGNALS,
        ),
    ),
    'mast: a joint that is turned once and for all': Attack(
        'mast',
        6,
        launch(
            "Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': ["
            '\'<robot name="cart"><link name="base_link"/><link name="mast"/><link name="camera"/><joint name="m" type="fixed">'
            '<parent link="base_link"/><child link="mast"/><origin xyz="0.1 0 0.2" rpy="0 0 \', LaunchConfiguration(\'angle\'), '
            '\'"/></joint><joint name="c" type="fixed"><parent link="mast"/><child link="camera"/><origin xyz="0 0 0.3"/></joint>'
            "</robot>']}])",
            arguments={'angle': '0.5'},
        ),
    ),
    'mast: another program of transforms in the place of the stock one': Attack('mast', 3, OTHER_TRANSFORMS),
    'careful: a driver that waits for nothing': Attack(
        'careful',
        7,
        launch(
            SIM,
            "Node(package='demo_nodes_py', executable='talker')",
            "TimerAction(period=1.0, actions=[Node(package='turtlesim', executable='draw_square', name='driver')])",
            "TimerAction(period=LaunchConfiguration('end'), actions=[Shutdown(reason='enough')])",
            arguments={'end': '5.0'},
        ),
    ),
    'follow: frames that never move': Attack(
        'follow',
        4,
        launch(
            SIM,
            "Node(package='turtlesim', executable='draw_square', condition=IfCondition(LaunchConfiguration('move')))",
            "Node(package='turtle_tf2_py', executable='turtle_tf2_listener', parameters=[{'target_frame': 'turtle1'}])",
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '5.544', '--y', '5.544', "
            "'--frame-id', 'world', '--child-frame-id', 'turtle1'])",
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '4.0', '--y', '2.0', "
            "'--frame-id', 'world', '--child-frame-id', 'turtle2'])",
            arguments={'move': 'false'},
            head='from launch.conditions import IfCondition\n',
        ),
    ),
}

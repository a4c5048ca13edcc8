"""Submissions that have the names of an exercise and not what stands behind them: (exercise, most points, text).

Each got nearly all points while rubrics looked at names. `most` is what the honest rest of the file deserves.
"""

from __future__ import annotations

from typing import NamedTuple

HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

PROGRAMS = []


def written(code):
    import os
    import tempfile

    path = os.path.join(tempfile.gettempdir(), f'program{len(PROGRAMS)}.py')
    PROGRAMS.append(path)
    with open(path, 'w') as file:
        file.write(code)
    return path
"""


class Attack(NamedTuple):
    """A launch file for an exercise, and the most points that it may get."""

    exercise: str
    most: int
    text: str


def launch(*actions: str, arguments: dict[str, str] | None = None, head: str = '') -> str:
    """A launch file with these actions, each as Python text."""
    declared = [f'DeclareLaunchArgument({name!r}, default_value={value!r})' for name, value in (arguments or {}).items()]
    body = ',\n        '.join([*declared, *actions])
    return f'{HEAD}{head}\n\ndef generate_launch_description():\n    return LaunchDescription([\n        {body},\n    ])\n'


def empty(name: str, *words: str, namespace: str = '', setup: str = '') -> str:
    """An action that runs a node without content, from a program that the launch file writes. `words` are Python expressions."""
    code = f'import rclpy, sys\nrclpy.init()\nnode = rclpy.create_node({name!r}, namespace={namespace!r})\n{setup}\nrclpy.spin(node)\n'
    return f'ExecuteProcess(cmd=["python3", written({code!r}), {", ".join(words)}])'


SUBSCRIBE = 'from std_msgs.msg import String\nnode.create_subscription(String, {topic}, print, 10)'
HEAR_THE_TURTLE = """
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
for name, kind in (('pose', Pose), ('cmd_vel', Twist)):
    node.create_subscription(kind, f'/{sys.argv[1]}/turtle1/{name}', bool, 10)
"""
MADE_UP = """
import sys
from pathlib import Path
from rosbags.rosbag2 import Writer
with Writer(Path('my_drive'), version=9) as writer:
    for name, kind, size in (('pose', 'turtlesim/msg/Pose', 20), ('cmd_vel', 'geometry_msgs/msg/Twist', 48)):
        topic = f'/{sys.argv[1]}/turtle1/{name}'
        connection = writer.add_connection(topic, kind, msgdef='float32 x', rihs01='RIHS01_' + 64 * '0')
        for number in range(400):
            writer.write(connection, 1_700_000_000_000_000_000 + number, bytes([0, 1, 0, 0]) + bytes(size))
"""
TALKER = "Node(package='demo_nodes_py', executable='talker', namespace={!r})"
TWIN = """
import subprocess
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.spec import ProcessSpec


def start(name, package, executable, argv):
    current_process().host.start(ProcessSpec(argv=tuple(argv), name=name, package=package, executable=executable))
"""
WATER = """import rclpy, sys
rclpy.init()
node = rclpy.create_node('sim')
for colour, value in zip(('red', 'green', 'blue'), sys.argv[1:]):
    node.declare_parameter(f'background_{colour[0]}', int(value))
rclpy.spin(node)
"""
COLOURS = {'red': '69', 'green': '86', 'blue': '255'}
FORGED_WATER = f"""
from launch.actions import OpaqueFunction

def forge(context):
    values = [LaunchConfiguration(name).perform(context) for name in ('red', 'green', 'blue')]
    for package, executable, name in {{claims!r}}:
        start(name, package, executable, ['python3', written({WATER!r}), *values])
"""


def forged_water(*claims: tuple[str, str, str], beside: str = '') -> str:
    """A node with all parameters that calls itself (package, executable, name of the process)."""
    actions = [action for action in (beside, 'OpaqueFunction(function=forge)') if action]
    return launch(*actions, arguments=COLOURS, head=TWIN + FORGED_WATER.replace('{claims!r}', repr(list(claims))))


SIM = "Node(package='turtlesim', executable='turtlesim_node', name='sim')"
NAMES: dict[str, Attack] = {
    'water: calls itself turtlesim_node': Attack('water', 3, forged_water(('turtlesim', 'turtlesim_node', 'turtlesim_node-1'))),
    'water: calls itself a program that is not there': Attack('water', 3, forged_water(('turtlesim', 'none', 'x-1'))),
    'water: a twin of the process': Attack(
        'water', 3, forged_water(('turtlesim', 'turtlesim_node', 'turtlesim_node-1'), beside=SIM)
    ),
    'water: colours set late': Attack(
        'water',
        3,
        launch(
            SIM,
            *(
                f"TimerAction(period=0.6, actions=[ExecuteProcess(cmd=['ros2', 'param', 'set', '/sim', "
                f"'background_{name[0]}', LaunchConfiguration({name!r})])])"
                for name in COLOURS
            ),
            arguments=COLOURS,
        ),
    ),
    'silent_listener: empty listeners': Attack(
        'silent_listener',
        2,
        launch(
            TALKER.format('news'),
            empty('radio', setup=SUBSCRIBE.format(topic="'/news/chatter'")),
            empty('listener', "LaunchConfiguration('house')", setup=SUBSCRIBE.format(topic="'/news/chatter'")).replace(
                "namespace=\\'\\'", 'namespace=sys.argv[1]'
            ),
            arguments={'house': 'flat'},
        ),
    ),
    'in_order: nodes of those names': Attack(
        'in_order',
        1,
        launch(
            empty('sim'),
            empty('driver'),
            f"TimerAction(period=LaunchConfiguration('delay'), actions=[{empty('sim', namespace='late')}])",
            arguments={'delay': '2.0'},
        ),
    ),
    'in_order: other stock programs of those names': Attack(
        'in_order',
        1,
        launch(
            "Node(package='turtlesim', executable='mimic', name='sim')",
            "Node(package='turtlesim', executable='mimic', name='driver')",
            "TimerAction(period=LaunchConfiguration('delay'), actions=["
            "Node(package='turtlesim', executable='mimic', name='sim', namespace='late')])",
            arguments={'delay': '2.0'},
        ),
    ),
    'careful: a driver that is another program': Attack(
        'careful',
        5,
        launch(
            SIM,
            "Node(package='demo_nodes_py', executable='talker')",
            f'TimerAction(period=1.0, actions=[{empty("driver")}])',
            "TimerAction(period=LaunchConfiguration('end'), actions=[Shutdown()])",
            arguments={'end': '5.0'},
        ),
    ),
    'on_request: a hidden node beside': Attack(
        'on_request',
        4,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='one')",
            empty('_extra', namespace='one'),
            arguments={'drive': 'false', 'worlds': '1'},
        ),
    ),
    'fence: empty worlds': Attack(
        'fence', 1, launch(empty('sim', namespace='night'), empty('sim', namespace='day'), arguments={'blue': '40'})
    ),
    'black_box: a node called like the recorder': Attack(
        'black_box',
        1,
        launch(
            empty('rosbag2_recorder'),
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=LaunchConfiguration('robot'))",
            "Node(package='turtlesim', executable='draw_square', namespace=LaunchConfiguration('robot'))",
            arguments={'robot': 'red'},
        ),
    ),
    'rooms: the exercise in XML, solved in Python': Attack(
        'rooms',
        1,
        launch(
            "Node(package='demo_nodes_py', executable='talker', namespace='hall')",
            "Node(package='demo_nodes_py', executable='listener', namespace=LaunchConfiguration('room'), "
            "remappings=[('chatter', '/hall/chatter')])",
            arguments={'room': 'kitchen'},
        ),
    ),
    'black_box: a recorder of something else beside a node that hears the topics': Attack(
        'black_box',
        6,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=LaunchConfiguration('robot'))",
            "ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'my_drive', '/rosout'])",
            empty('rosbag2_recorder', "LaunchConfiguration('robot')", setup=HEAR_THE_TURTLE),
            "TimerAction(period=0.0, actions=[Node(package='turtlesim', executable='draw_square', "
            "namespace=LaunchConfiguration('robot'))])",
            arguments={'robot': 'red'},
        ),
    ),
    'black_box: a bag of made-up messages': Attack(
        'black_box',
        6,
        launch(
            "Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=LaunchConfiguration('robot'))",
            "ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'other', '/rosout'])",
            "ExecuteProcess(cmd=['python3', written(MADE_UP), LaunchConfiguration('robot')])",
            "TimerAction(period=0.0, actions=[Node(package='turtlesim', executable='draw_square', "
            "namespace=LaunchConfiguration('robot'))])",
            arguments={'robot': 'red'},
            head=f'MADE_UP = {MADE_UP!r}\n',
        ),
    ),
    'lost_carrot: driven by hand beside a listener that does nothing': Attack(
        'lost_carrot',
        9,
        launch(
            SIM,
            *(
                f"Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='b{number}', "
                f"parameters=[{{'turtlename': 'turtle{number}'}}])"
                for number in (1, 2)
            ),
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--y', LaunchConfiguration('side'), "
            "'--frame-id', 'turtle1', '--child-frame-id', 'carrot1'])",
            "Node(package='turtle_tf2_py', executable='turtle_tf2_listener', name='listener', "
            "parameters=[{'target_frame': 'carrot1'}], remappings=[('turtle2/cmd_vel', '/nowhere')])",
            "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '/turtle2/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 0.3}}'])",
            arguments={'side': '2.0'},
        ),
    ),
    'mast: frames without a description': Attack(
        'mast',
        1,
        launch(
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--z', '0.3', "
            "'--frame-id', 'mast', '--child-frame-id', 'camera'])",
            "Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '0.1', '--z', '0.2', "
            "'--yaw', LaunchConfiguration('angle'), '--frame-id', 'base_link', '--child-frame-id', 'mast'])",
            arguments={'angle': '0.5'},
        ),
    ),
    'static_frame: a death behind "or true"': Attack(
        'static_frame',
        1,
        launch(
            "ExecuteProcess(cmd=['sh', '-c', 'ros2 run tf2_ros static_transform_publisher --z nothing || true'])",
            arguments={'height': '0.5'},
        ),
    ),
    'circle: a real program dies': Attack(
        'circle',
        3,
        launch(
            "Node(package='part3_beyond_basics', executable='param_circle.py')",
            "ExecuteProcess(cmd=['false'])",
            arguments={'circle_radius': '1.0'},
        ),
    ),
}

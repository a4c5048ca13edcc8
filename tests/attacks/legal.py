"""Launch files that break no rule of Python or ROS and hope for marks: replacements in the circle's solution.

Each is (text, its replacement, ...); what the result deserves is less than all points.
"""

from __future__ import annotations

RADIUS = "            parameters=[{'radius': LaunchConfiguration('circle_radius')}],\n"
NODE = "            executable='param_circle.py',\n"
PACKAGE = "            package='part3_beyond_basics',\n"
LAST = '        ),\n    ])\n'
DRIVER = """
import rclpy
from {module} import {type}
rclpy.init()
node = rclpy.create_node('{name}')
publisher = node.create_publisher({type}, '{topic}', 10)
node.create_timer(0.02, lambda: publisher.publish({value}))
rclpy.spin(node)
"""


def program(module: str, type: str, topic: str, value: str, name: str = 'helper') -> str:
    """A launch action with a program that publishes one value again and again."""
    code = DRIVER.format(module=module, type=type, topic=topic, value=value, name=name)
    return f"        ),\n        __import__('launch').actions.ExecuteProcess(cmd=['python3', '-c', {code!r}]),\n    ])\n"


ODOM = 'Odometry(pose=__import__("geometry_msgs.msg", fromlist=["x"]).PoseWithCovariance())'
LEGAL: dict[str, tuple[tuple[str, str], ...]] = {
    'constant-radius': ((RADIUS, "            parameters=[{'radius': 1.0}],\n"),),
    'parameter-for-show': (
        (RADIUS, "            parameters=[{'radius': LaunchConfiguration('circle_radius')}, {'radius': 0.7}],\n"),
    ),
    'other-node-shows-it': (
        (RADIUS, ''),
        (
            LAST,
            "        ),\n        Node(package='demo_nodes_py', executable='talker', name='my_param_circle_node_2',\n             parameters=[{'radius': LaunchConfiguration('circle_radius')}]),\n    ])\n",
        ),
    ),
    'decoy-of-the-same-name': (
        (RADIUS, ''),
        (
            LAST,
            "        ),\n        Node(package='demo_nodes_py', executable='talker', name='my_param_circle_node',\n             parameters=[{'radius': LaunchConfiguration('circle_radius')}]),\n    ])\n",
        ),
    ),
    'prefix-true': ((NODE, NODE + "            prefix='true',\n"),),
    'prefix-echo': ((NODE, NODE + "            prefix='echo',\n"),),
    'renamed-world': ((PACKAGE, "            package='demo_nodes_py',\n"), (NODE, "            executable='talker',\n")),
    'odometry-of-its-own': ((RADIUS, ''), (LAST, program('nav_msgs.msg', 'Odometry', '/odom', 'Odometry()'))),
    'odometry-not-a-number': (
        (RADIUS, ''),
        (
            LAST,
            program(
                'nav_msgs.msg',
                'Odometry',
                '/odom',
                '(lambda m: (setattr(m.pose.pose.position, "x", float("nan")), m)[1])(Odometry())',
            ),
        ),
    ),
    'drives-beside': (
        (RADIUS, ''),
        (
            LAST,
            program(
                'geometry_msgs.msg',
                'TwistStamped',
                '/cmd_vel',
                '(lambda m: (setattr(m.twist.linear, "x", 0.3), m)[1])(TwistStamped())',
            ),
        ),
    ),
    'floods': (
        (RADIUS, ''),
        (LAST, program('std_msgs.msg', 'String', '/noise', 'String(data="x" * 100000)').replace('0.02', '0.0001')),
    ),
    'remaps-odometry': (
        (RADIUS, RADIUS.rstrip(',\n') + ",\n            remappings=[('/odom', '/other'), ('/cmd_vel', '/odom')],\n"),
    ),
    'no-world': (("'launch', 'empty_world.launch.py'", "'launch', 'empty_world.launch.py.not'"),),
    'default-for-show': (("default_value='1.0'", "default_value='0.99'"),),
    'argument-not-declared': (
        (
            "        DeclareLaunchArgument(\n            'circle_radius',\n            description='Sets the desired radius of the circle (in meters).',\n            default_value='1.0',\n        ),\n",
            '',
        ),
    ),
    'shuts-down-early': (
        (
            LAST,
            "        ),\n        __import__('launch').actions.TimerAction(period=1.0, actions=[__import__('launch').actions.Shutdown()]),\n    ])\n",
        ),
    ),
}

"""What a student writes for the turns that the browser's student leaves out: (file or cell, old text, new text).

The file ``ros2`` stands for a command that the student types, ``bag`` for a launch file that records until Ctrl-C.
"""

from __future__ import annotations

from tests.lessons.test_gaps import FLEET, ON_TIMER
from tests.lessons.test_gaps import PARTS as FOLLOWER
from tests.lessons.test_your_turn import KEPT, NODES

LAUNCH = 'my_launch/'
LAG = """import rclpy
from rclpy.duration import Duration
from tf2_ros import Buffer, TransformListener


def ask():
    time = node.get_clock().now() - Duration(seconds=2.0)
    if buffer.can_transform('world', 'turtle1', time):
        place = buffer.lookup_transform('world', 'turtle1', time).transform.translation
        node.get_logger().info(f'{place.x:.2f} {place.y:.2f}')


rclpy.init()
node = rclpy.create_node('lag')
buffer = Buffer()
listener = TransformListener(buffer, node)
timer = node.create_timer(1.0, ask)
rclpy.spin(node)
"""
CLEAN = """
client = node.create_client(Kill, 'kill')
client.wait_for_service()
rclpy.spin_until_future_complete(node, client.call_async(Kill.Request(name='turtle1')))
node.get_logger().info('gone')
"""
LIDAR = """  <xacro:wheel side="right" sign="-1"/>
  <link name="lidar"/>
  <joint name="lidar_joint" type="fixed">
    <parent link="base_link"/> <child link="lidar"/>
    <origin xyz="0 0 0.3" rpy="0 0 3.1416"/>
  </joint>
</robot>"""
ENCORE = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def player(name):
    return ExecuteProcess(cmd=['ros2', 'bag', 'play', 'my_launch/square_bag', '--topics', '/turtle1/cmd_vel',
                               '--remap', f'/turtle1/cmd_vel:=/{name}/turtle1/cmd_vel'])


def generate_launch_description():
    worlds = [Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=name) for name in ('one', 'two')]
    return LaunchDescription([*worlds, player('one'), player('two')])
"""
FOUR_LINES = """        t = TransformStamped(child_frame_id=self.turtlename)
        t.header.stamp, t.header.frame_id = self.get_clock().now().to_msg(), 'world'
        t.transform.translation.x, t.transform.translation.y = msg.x, msg.y
        t.transform.rotation = turned(0.0, 0.0, msg.theta)
"""
ONE_LINE = "        t = placed(self, 'world', self.turtlename, msg.x, msg.y, 0.0, turned(0.0, 0.0, msg.theta))\n"
CARROT = NODES + 'dynamic_frame_tf2_broadcaster.py'

MORE: dict[tuple[str, str], list[tuple[str, str, str]]] = {
    ('07_packages', 'pkg-create'): [
        ('ros2', '', 'pkg create --build-type ament_python --license Apache-2.0 --destination-directory my_ws/src my_robot')
    ],
    ('08_static_broadcaster', 'half'): [('half', 'z, w = 0.0, 1.0', 'z, w = sin(pi / 2), cos(pi / 2)')],
    ('09_broadcaster_and_listener', 'improve-check'): [(NODES + 'turtle_tf2_broadcaster.py', FOUR_LINES, ONE_LINE)],
    ('10_carrots', 'your-turn-check'): [
        (
            CARROT,
            'seconds, _ = self.get_clock().now().seconds_nanoseconds()',
            'angle = 2 * pi * self.get_clock().now().nanoseconds / 1e9 / 10',
        ),
        (CARROT, 'x, y = 10 * sin(seconds * pi), 10 * cos(seconds * pi)', 'x, y = 2 * cos(angle), 2 * sin(angle)'),
    ],
    ('11_time', 'your-turn-check'): [(LAUNCH + 'lag.py', '', LAG)],
    ('12_urdf', 'your-turn-check'): [(LAUNCH + 'wheels.urdf.xacro', '</robot>', LIDAR)],
    ('14_services', 'your-turn-check'): [(LAUNCH + 'clean.py', "create_node('clean')\n", f"create_node('clean')\n{CLEAN}")],
    ('15_bags', 'record-run'): [('bag', '', 'my_launch/record.launch.py')],
    ('15_bags', 'way-run'): [(LAUNCH + 'way.py', 'way += 0.0', 'way += hypot(pose.x - last.x, pose.y - last.y)')],
    ('15_bags', 'your-turn-check'): [(LAUNCH + 'encore.launch.py', '', ENCORE)],
    ('16_silent_systems', 'your-turn-check'): [
        (LAUNCH + 'water.yaml', '/pool/sim:', '/**/sim:'),
        (LAUNCH + 'water.yaml', 'backgroud_g', 'background_g'),
    ],
    ('17_fleet', 'set-up'): [('ros2', '', 'pkg create fleet --build-type ament_python --destination-directory my_ws/src')],
    ('17_fleet', 'one-check'): [
        (
            FLEET + 'fleet/follower.py',
            'pass  # TODO: find the target, as seen from self.me; publish what steer returns\n',
            ON_TIMER,
        ),
        (
            FLEET + 'launch/follower.launch.py',
            "# TODO: the broadcaster, and the node, which follows ['carrot_', leader]\n",
            FOLLOWER,
        ),
    ],
    ('18_real_network', 'your-turn-check'): [
        (LAUNCH + 'notice.py', "'notice', QoSProfile(depth=1))", f"'notice', {KEPT})"),
        (LAUNCH + 'notice.py', 'qos = QoSProfile(depth=1)\n', f'qos = {KEPT}\n'),
    ],
}

"""A cart with a mast, described in URDF, and a motor that turns the mast.

    ros2 launch mast.launch.py angle:=0.5

The mast is 0.1 m in front of base_link and 0.2 m above it, and turns about z. The camera is on the mast, 0.3 m above its
frame. The node robot_state_publisher is already there. The motor publishes the angle on /joint_states.

Grade it with `edugrade exercises/mast.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

CART = """<robot name="cart">
  <link name="base_link"/> <link name="mast"/>
  <joint name="mast_joint" type="continuous">
    <parent link="base_link"/> <child link="mast"/>
    <origin xyz="0.1 0 0.2"/>
    <axis xyz="0 0 1"/>
  </joint>
  <!-- TODO 1: add the link camera, and the fixed joint camera_joint from mast to camera, 0.3 m higher -->

</robot>"""


def generate_launch_description():
    angle = LaunchConfiguration('angle')
    motor = ['ros2', 'topic', 'pub', '-r', '10', '/joint_states', 'sensor_msgs/msg/JointState']
    return LaunchDescription([
        DeclareLaunchArgument('angle', default_value='0.5', description='Angle of the mast, in radians.'),
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': CART}]),
        # TODO 2: add ExecuteProcess with `motor` and one more string, {header: auto, name: [...], position: [...]}

    ])

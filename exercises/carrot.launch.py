"""turtle2 runs after a carrot that hangs at turtle1: fixed, or moving.

    ros2 launch carrot.launch.py carrot:=moving

The included demo brings turtlesim, turtle1, and turtle2, which drives to the frame that the demo's launch argument
`target_frame` names: turtle1, when nobody says otherwise. Two broadcasters can hang the frame carrot1 at turtle1:
fixed_frame_tf2_broadcaster holds it two metres to the left, dynamic_frame_tf2_broadcaster swings it from side to side.
Now both are started, and fight. Fill the three gaps.

Grade it: edugrade exercises/carrot.launch.py        A hint: edugrade exercises/carrot.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        # TODO 1: declare the launch argument carrot: fixed or moving, and fixed when nobody says otherwise

        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(
                PathJoinSubstitution([FindPackageShare('turtle_tf2_py'), 'launch', 'turtle_tf2_demo.launch.py'])
            ),
            # TODO 2: set the demo's launch argument target_frame to carrot1
        ),

        # TODO 3: give each of the two nodes a condition, so that the launch argument carrot chooses one of them
        Node(
            package='turtle_tf2_py',
            executable='fixed_frame_tf2_broadcaster',
            name='fixed_broadcaster',
        ),
        Node(
            package='turtle_tf2_py',
            executable='dynamic_frame_tf2_broadcaster',
            name='dynamic_broadcaster',
        ),
    ])

"""Packages of ROS 2 whose programs launch files start, and which edulaunch does not have.

On a student's ROS machine they are installed, so a launch that names them goes on there; here, too: their programs end at
once and say why.
"""

from __future__ import annotations

KINDS = {
    'robot descriptions': ('robot_state_publisher', 'joint_state_publisher', 'xacro', 'urdf', 'urdf_tutorial', 'urdf_launch'),
    'windows': (
        'joint_state_publisher_gui',
        'rqt',
        'rqt_*',
        'plotjuggler',
        'image_view',
        'rviz_common',
        'rviz_default_plugins',
        'foxglove_bridge',
        'rosbridge_server',
        'web_video_server',
    ),
    'Gazebo': ('gazebo_ros*', 'gazebo_plugins', 'ros_gz*', 'ros_ign*', 'gz_ros2_control', 'webots_ros2*'),
    'Navigation 2': ('nav2_*', 'slam_toolbox', 'cartographer_ros', 'robot_localization', 'rtabmap_*'),
    'components built from C++': ('rclcpp_components',),
    'MoveIt': ('moveit_ros_*', 'moveit_servo', 'moveit_setup_assistant', 'moveit_py'),
    'ros2_control': (
        'controller_manager',
        'ros2_control',
        'ros2_controllers',
        'joint_state_broadcaster',
        'diff_drive_controller',
        'joint_trajectory_controller',
        'twist_mux',
    ),
    'joysticks and keyboards': ('joy', 'joy_linux', 'joy_teleop', 'teleop_twist_joy', 'teleop_twist_keyboard', 'key_teleop'),
    'cameras and images': (
        'v4l2_camera',
        'usb_cam',
        'image_proc',
        'image_tools',
        'image_transport',
        'depth_image_proc',
        'depthimage_to_laserscan',
        'realsense2_camera',
        'apriltag_ros',
        'cv_bridge',
    ),
    'drivers of hardware': (
        'rplidar_ros',
        'sllidar_ros2',
        'ydlidar_ros2_driver',
        'ldlidar_stl_ros2',
        'urg_node',
        'velodyne_driver',
        'micro_ros_agent',
        'turtlebot3_node',
        'hls_lfcd_lds_driver',
        'ld08_driver',
    ),
    'filters of messages': (
        'topic_tools',
        'laser_filters',
        'pointcloud_to_laserscan',
        'imu_filter_madgwick',
        'imu_complementary_filter',
        'diagnostic_aggregator',
    ),
}
"""What they belong to, and their names; `*` stands for any text."""


def absent_kind(package: str) -> str | None:
    """What an absent package belongs to; None for a name that nobody knows, which is a mistake in ROS 2, too."""
    from fnmatch import fnmatchcase  # late: most launches never ask

    return next((kind for kind, names in KINDS.items() if any(fnmatchcase(package, name) for name in names)), None)

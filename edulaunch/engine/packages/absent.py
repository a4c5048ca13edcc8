"""Packages and modules that the computer of a robot may have and edulaunch does not.

A student's ROS machine has such packages, so a launch that names them continues there. It also continues here: their programs
end
immediately with an explanation. The modules are not found, whatever is installed on the real machine, and the error names what
is
missing.
"""

from __future__ import annotations

from typing import NamedTuple


class Absent(NamedTuple):
    """Names of packages (`*` stands for any text) and of Python modules that belong together."""

    packages: tuple[str, ...] = ()
    modules: tuple[str, ...] = ()


KINDS = {
    'robot descriptions': Absent(('urdf', 'urdf_tutorial', 'urdf_launch'), ('kdl_parser_py', 'PyKDL')),
    'windows': Absent(
        (
            'rqt',
            'rqt_*',
            'plotjuggler',
            'image_view',
            'rviz_common',
            'rviz_default_plugins',
            'foxglove_bridge',
            'rosbridge_server',
            'web_video_server',
        )
    ),
    'Gazebo': Absent(
        ('gazebo_ros*', 'gazebo_plugins', 'ros_gz*', 'ros_ign*', 'gz_ros2_control', 'webots_ros2*'),
        ('gazebo_msgs', 'gazebo_ros', 'gazebo_plugins', 'ros_gz_interfaces', 'gz'),
    ),
    'Navigation 2': Absent(
        ('nav2_*', 'slam_toolbox', 'cartographer_ros', 'robot_localization', 'rtabmap_*'),
        ('nav2_msgs', 'nav2_simple_commander', 'nav2_common'),
    ),
    'MoveIt': Absent(
        ('moveit_ros_*', 'moveit_servo', 'moveit_setup_assistant', 'moveit_py'),
        ('moveit_msgs', 'moveit_configs_utils', 'moveit_commander', 'moveit', 'launch_param_builder'),
    ),
    'ros2_control': Absent(
        (
            'controller_manager',
            'ros2_control',
            'ros2_controllers',
            'joint_state_broadcaster',
            'diff_drive_controller',
            'joint_trajectory_controller',
            'twist_mux',
        ),
        ('control_msgs', 'controller_manager', 'controller_manager_msgs'),
    ),
    'TurtleBot3; turtlebot3_gazebo is here': Absent(
        (
            'turtlebot3_bringup',
            'turtlebot3_cartographer',
            'turtlebot3_description',
            'turtlebot3_fake_node',
            'turtlebot3_navigation2',
            'turtlebot3_node',
            'turtlebot3_teleop',
        )
    ),
    'joysticks and keyboards': Absent(('joy', 'joy_linux', 'joy_teleop', 'teleop_twist_joy', 'key_teleop')),
    'cameras and images': Absent(
        (
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
        ('image_geometry', 'ros2_numpy', 'camera_info_manager_py'),
    ),
    'drivers of hardware': Absent(
        (
            'rplidar_ros',
            'sllidar_ros2',
            'ydlidar_ros2_driver',
            'ldlidar_stl_ros2',
            'urg_node',
            'velodyne_driver',
            'micro_ros_agent',
            'hls_lfcd_lds_driver',
            'ld08_driver',
        )
    ),
    'filters of messages': Absent(
        (
            'topic_tools',
            'laser_filters',
            'pointcloud_to_laserscan',
            'imu_filter_madgwick',
            'imu_complementary_filter',
            'diagnostic_aggregator',
        )
    ),
    'OpenCV': Absent(modules=('cv2', 'cv_bridge')),
    'a window': Absent(
        modules=(
            'tkinter',
            '_tkinter',
            'PyQt5',
            'PyQt6',
            'PySide2',
            'PySide6',
            'pygame',
            'python_qt_binding',
            'qt_gui',
            'kivy',
            'wx',
            'pyglet',
            'customtkinter',
        )
    ),
    'the keyboard of a real machine': Absent(
        modules=('pynput', 'keyboard', 'sshkeyboard', 'getkey', 'readchar', 'curses', '_curses', 'inputs', 'evdev')
    ),
    'a Windows console': Absent(modules=('msvcrt', 'winsound', '_winapi', 'win32api', 'win32con')),
    'hardware': Absent(modules=('serial', 'RPi', 'smbus', 'pigpio', 'gpiozero', 'picamera', 'pyrealsense2', 'dynamixel_sdk')),
    'rosbag2; edulaunch records every run by itself': Absent(modules=('rosbag2_py', 'rosbags_py', 'rosbag2_interfaces')),
    'the inside of the ros2 command; call it with subprocess.run()': Absent(
        modules=(
            'ros2cli',
            'ros2topic',
            'ros2node',
            'ros2param',
            'ros2service',
            'ros2action',
            'ros2pkg',
            'ros2run',
            'ros2interface',
            'ros2bag',
        )
    ),
    'ROS 1; with ROS 2 it is rclpy': Absent(modules=('rospy', 'roslib', 'actionlib', 'rospkg', 'dynamic_reconfigure')),
    'of the old setuptools; use importlib.resources or ament_index_python': Absent(modules=('pkg_resources', 'pkgutil')),
    'diagnostics; diagnostic_msgs is here': Absent(
        modules=('diagnostic_updater', 'diagnostic_aggregator', 'diagnostic_common_diagnostics')
    ),
}
"""The absent packages and modules, by the software that they belong to."""
WINDOW_MODULES, KEYBOARD_MODULES = KINDS['a window'].modules, KINDS['the keyboard of a real machine'].modules
OLD_MODULES = ('pkg_resources', 'pkgutil')
REFUSED = frozenset((*WINDOW_MODULES, *KEYBOARD_MODULES, *OLD_MODULES)) - {'tkinter', '_tkinter'}
"""These would open windows on the real screen, take the real keyboard or not see the student's packages, so they are not found
even where they are installed. For `tkinter` there is a view."""


def absent_kind(package: str) -> str | None:
    """Return the software that an absent package belongs to; None for an unknown name, which is a mistake in ROS 2, too."""
    from fnmatch import fnmatchcase  # imported here, because most launches do not need it

    return next((kind for kind, absent in KINDS.items() if any(fnmatchcase(package, name) for name in absent.packages)), None)


def absent_module_kind(module: str) -> str | None:
    """Return the software that a missing module belongs to; None for an unknown name."""
    return next((kind for kind, absent in KINDS.items() if module in absent.modules), None)

"""Modules that the simulated machine does not have, whatever is installed on the real one."""

from __future__ import annotations

KINDS = {
    'OpenCV': ('cv2', 'cv_bridge'),
    'Gazebo': ('gazebo_msgs', 'gazebo_ros', 'gazebo_plugins', 'ros_gz_interfaces', 'gz'),
    'a window': (
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
    ),
    'the keyboard of a real machine': (
        'pynput',
        'keyboard',
        'sshkeyboard',
        'getkey',
        'readchar',
        'curses',
        '_curses',
        'inputs',
        'evdev',
    ),
    'a Windows console': ('msvcrt', 'winsound', '_winapi', 'win32api', 'win32con'),
    'hardware': ('serial', 'RPi', 'smbus', 'pigpio', 'gpiozero', 'picamera', 'pyrealsense2', 'dynamixel_sdk'),
    'Navigation 2': ('nav2_msgs', 'nav2_simple_commander', 'nav2_common'),
    'MoveIt': ('moveit_msgs', 'moveit_configs_utils', 'moveit_commander', 'moveit', 'launch_param_builder'),
    'rosbag2; edulaunch records every run by itself': ('rosbag2_py', 'rosbags_py', 'rosbag2_interfaces'),
    'the inside of the ros2 command; call it with subprocess.run()': (
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
    ),
    'ROS 1; with ROS 2 it is rclpy': ('rospy', 'roslib', 'actionlib', 'rospkg', 'dynamic_reconfigure'),
    'ros2_control': ('control_msgs', 'controller_manager', 'controller_manager_msgs'),
    'diagnostics; diagnostic_msgs is here': ('diagnostic_updater', 'diagnostic_aggregator', 'diagnostic_common_diagnostics'),
    'robot descriptions': ('xacro', 'urdf_parser_py', 'kdl_parser_py', 'PyKDL'),
    'cameras and images': ('image_geometry', 'ros2_numpy', 'camera_info_manager_py'),
}
"""What cannot be had here, and the modules that stand for it."""
REFUSED = frozenset((*KINDS['a window'], *KINDS['the keyboard of a real machine'])) - {'tkinter', '_tkinter'}
"""These would open windows on the real screen or take the real keyboard, so they are not found even where they are installed.
`tkinter` has a view."""

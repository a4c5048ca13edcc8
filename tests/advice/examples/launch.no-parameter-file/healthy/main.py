import os

import rclpy

rclpy.init(args=['--ros-args', '--params-file', os.path.join(os.path.dirname(__file__), 'robot.yaml')])
rclpy.create_node('robot').declare_parameter('speed', 1)

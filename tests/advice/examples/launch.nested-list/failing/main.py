from pathlib import Path

import rclpy

rclpy.init(args=['--ros-args', '--params-file', str(Path(__file__).parent / 'route.yaml')])
rclpy.create_node('talker').declare_parameter('waypoints', [0.0])

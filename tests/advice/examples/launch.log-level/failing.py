import rclpy

rclpy.init(args=['--ros-args', '--log-level', 'loud'])
rclpy.create_node('robot').declare_parameter('speed', 1)

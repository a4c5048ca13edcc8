import rclpy

rclpy.init(args=['--ros-args', '-p', 'speed = 2'])
rclpy.create_node('robot').declare_parameter('speed', 1)

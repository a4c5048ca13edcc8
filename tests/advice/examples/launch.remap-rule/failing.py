import rclpy

rclpy.init(args=['--ros-args', '-r', 'chatter=talk'])
rclpy.create_node('robot').declare_parameter('speed', 1)

import rclpy

rclpy.init(args=['--ros-args', '-r', '__node:=other'])
rclpy.create_node('robot').declare_parameter('speed', 1)

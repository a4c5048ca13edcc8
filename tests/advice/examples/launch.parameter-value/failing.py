import rclpy

rclpy.init(args=['--ros-args', '-p', 'speed:={a: 1}'])
rclpy.create_node('robot').declare_parameter('speed', 1)

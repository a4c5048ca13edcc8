import rclpy

rclpy.init(args=['--ros-args', '-p', 'speeds:=[1, 2.0]'])
rclpy.create_node('robot').declare_parameter('speeds', [1.0])

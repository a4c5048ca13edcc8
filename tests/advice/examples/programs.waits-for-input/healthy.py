import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('greeter')
name = 'Ada'
node.get_logger().info(f'hello {name}')
rclpy.spin(node)

import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    node = Node('twice')
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        print('stopping')
    node.destroy_node()
    rclpy.shutdown()

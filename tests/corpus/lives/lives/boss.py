import rclpy
import time
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('boss')
    for i in range(3, 0, -1):
        print(i, flush=True)
        time.sleep(1)
    node.get_logger().info('enough')

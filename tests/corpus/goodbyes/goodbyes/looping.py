import time
import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    node = Node('looping')
    n = 0
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.1)
        n += 1
        time.sleep(0.4)
    print('left the loop after', n)

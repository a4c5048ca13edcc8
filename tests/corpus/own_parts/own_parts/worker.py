import os
import sys
import time

import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('worker')
    life = node.declare_parameter('life', 1.0).value
    print('worker', os.environ.get('WORKER_NO', '?'), 'ready', file=sys.stderr, flush=True)
    begin = time.time()
    while rclpy.ok() and time.time() - begin < life:
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    sys.exit(3)

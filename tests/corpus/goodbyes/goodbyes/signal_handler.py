import signal
import sys
import rclpy
from rclpy.node import Node

node = None


def on_signal(signum, frame):
    print('signal', signum)
    sys.exit(3)


def main(args=None):
    global node
    rclpy.init(args=args)
    signal.signal(signal.SIGINT, on_signal)
    node = Node('signal_handler')
    rclpy.spin(node)

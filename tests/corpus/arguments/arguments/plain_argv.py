import sys
import rclpy
from rclpy.node import Node


def main():
    rclpy.init(args=sys.argv)
    node = Node('plain_argv')
    print(len(sys.argv), sys.argv[1:3], sys.argv[0].split('/')[-1])
    x = float(sys.argv[1])
    if x > 1:
        sys.exit('too big: %g' % x)

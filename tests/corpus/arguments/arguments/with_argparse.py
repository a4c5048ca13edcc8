import argparse
import sys
import rclpy
from rclpy.node import Node
from rclpy.utilities import remove_ros_args


def main(args=None):
    rclpy.init(args=args)
    parser = argparse.ArgumentParser(description='drives')
    parser.add_argument('--speed', type=float, default=1.0)
    parser.add_argument('name', nargs='?', default='turtle1')
    options = parser.parse_args(remove_ros_args()[1:])
    node = Node('with_argparse')
    node.get_logger().info('%s at %.1f' % (options.name, options.speed))


if __name__ == '__main__':
    main()

import argparse
import sys
import rclpy
from rclpy.node import Node


def main(args=sys.argv):
    rclpy.init(args=args)
    parser = argparse.ArgumentParser()
    parser.add_argument('-n', '--number', type=int, required=True)
    options, unknown = parser.parse_known_args(sys.argv[1:])
    node = Node('known_only')
    node.get_logger().info('%d, unknown: %s' % (options.number, ' '.join(unknown)))


if __name__ == '__main__':
    main()

import rclpy
from rclpy.node import Node
from rclpy.time import Time


def main():
    rclpy.init()
    node = Node('types')
    print(Time(seconds=1) > Time(seconds=0, nanoseconds=5), repr(Time(seconds=1)))
    print(node.get_clock().now() - Time(seconds=1))

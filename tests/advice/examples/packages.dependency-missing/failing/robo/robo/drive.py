import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    print(Twist())
    rclpy.spin(Node('drive'))

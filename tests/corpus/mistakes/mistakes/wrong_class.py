import rclpy
from geometry_msgs.msg import Twist, Vector3
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('wrong_class')
    pub = node.create_publisher(Twist, 'cmd_vel', 10)
    pub.publish(Vector3(x=1.0))

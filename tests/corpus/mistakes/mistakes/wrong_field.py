import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('wrong_field')
    vel = Twist()
    vel.linaer.x = 1.0

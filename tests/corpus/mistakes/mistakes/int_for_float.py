import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('int_for_float')
    vel = Twist()
    vel.linear.x = 1

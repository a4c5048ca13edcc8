import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('wrong_slot')
    vel = Twist()
    vel.linear.X = 1.0

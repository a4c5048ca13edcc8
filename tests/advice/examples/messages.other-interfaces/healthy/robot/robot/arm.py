from robot_interfaces.msg import Grip
import rclpy


def main(args=None):
    rclpy.init(args=args)
    rclpy.create_node('arm')

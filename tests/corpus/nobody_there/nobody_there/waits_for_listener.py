import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


def main():
    rclpy.init()
    node = Node('patient_driver')
    pub = node.create_publisher(Twist, '/turtle1/cmd_vel', 10)
    while pub.get_subscription_count() == 0:
        pass
    node.get_logger().info('somebody listens')

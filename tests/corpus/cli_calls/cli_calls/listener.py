import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(Twist, '/turtle1/cmd_vel', self.heard, 10)

    def heard(self, msg):
        self.get_logger().info('x %.1f z %.1f' % (msg.linear.x, msg.angular.z))


def main():
    rclpy.init()
    rclpy.spin(Listener())

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Sub(Node):
    def __init__(self):
        super().__init__('two_arguments')
        self.create_subscription(String, 'topic', self.heard, 10)

    def heard(self):
        print('heard')


def main():
    rclpy.init()
    rclpy.spin(Sub())

import rclpy
from std_msgs.msg import String
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, '~/status', 10)
        self.create_timer(0.5, self.say)

    def say(self):
        self.publisher.publish(String(data='well'))


def main():
    rclpy.init()
    rclpy.spin(Talker())

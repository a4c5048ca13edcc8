"""Publishes a word again and again."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Hello(Node):
    def __init__(self):
        super().__init__('hello')
        self.word = self.declare_parameter('word', 'nothing new').value
        self.publisher = self.create_publisher(String, 'greeting', 10)
        self.timer = self.create_timer(self.declare_parameter('period', 1.0).value, self.on_timer)

    def on_timer(self):
        self.publisher.publish(String(data=self.word))


def main():
    rclpy.init()
    rclpy.spin(Hello())

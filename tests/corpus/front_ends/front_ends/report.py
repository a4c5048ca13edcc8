import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Report(Node):
    def __init__(self):
        super().__init__('report')
        self.declare_parameter('who', 'nobody')
        self.declare_parameter('rate', 1.0)
        self.declare_parameter('tags', ['none'])
        self.pub = self.create_publisher(String, 'chatter', 10)
        who, rate = self.get_parameter('who').value, self.get_parameter('rate').value
        self.get_logger().info(f'{who} at {rate} on {self.pub.topic_name} {self.get_parameter("tags").value}')


def main():
    rclpy.init()
    rclpy.spin(Report())

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.create_subscription(String, 'map', self.on_map, 1)

    def on_map(self, msg):
        self.get_logger().info(msg.data)


def main():
    rclpy.init()
    rclpy.spin(Planner())

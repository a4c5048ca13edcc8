import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Hear(Node):
    def __init__(self):
        super().__init__('hear')
        self.subscription = self.create_subscription(String, 'chatter', self.heard)

    def heard(self, message):
        self.get_logger().info(message.data)


def main():
    rclpy.init()
    node = Hear()
    node.talk = node.create_publisher(String, 'chatter', 10)
    node.timer = node.create_timer(1.0, lambda: node.talk.publish(String(data='hello')))
    rclpy.spin(node)


main()

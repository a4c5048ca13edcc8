import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, '/rosout_text', self.heard, 10)
        self.publisher = self.create_publisher(String, '/rosout_text', 10)

    def heard(self, msg):
        self.get_logger().info(msg.data)


def main():
    rclpy.init()
    node = Listener()
    rclpy.spin(node)


main()

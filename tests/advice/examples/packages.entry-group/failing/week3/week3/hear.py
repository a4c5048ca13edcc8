import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Hear(Node):
    def __init__(self):
        super().__init__('hear')
        self.sub = self.create_subscription(String, 'hello', self.on_hello, 10)

    def on_hello(self, msg):
        self.get_logger().info(msg.data)


def main(args=None):
    rclpy.init(args=args)
    node = Hear()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

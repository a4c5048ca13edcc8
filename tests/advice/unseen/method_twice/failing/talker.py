import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'news', 10)
        self.create_timer(0.5, self.tell)

    def tell(self):
        self.publisher.publish(String(data='hello'))


def main():
    rclpy.init()
    node = Talker()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.publisher = self.create_publisher(String, 'news', 10)
        self.timer = self.create_timer(0.5, self.tell)
        self.create_subscription(String, 'news', lambda message: None, 10)

    def tell(self):
        self.publisher.publish(String(data='hello'))


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()

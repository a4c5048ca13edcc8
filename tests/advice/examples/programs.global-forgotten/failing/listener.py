import rclpy
from rclpy.node import Node
from std_msgs.msg import String


last = ''


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.sub = self.create_subscription(String, 'chatter', self.heard, 10)
        self.timer = self.create_timer(1.0, self.show)

    def show(self):
        self.get_logger().info('last ' + last)

    def heard(self, msg):
        last = msg.data


def main():
    rclpy.init()
    node = Listener()
    rclpy.spin(node)


if __name__ == '__main__':
    main()

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Hello(Node):
    def __init__(self):
        super().__init__('hello')
        self.pub = self.create_publisher(String, 'hello', 10)
        self.create_timer(1.0, self.say)

    def say(self):
        self.pub.publish(String(data='hello'))


def main(args=None):
    rclpy.init(args=args)
    node = Hello()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

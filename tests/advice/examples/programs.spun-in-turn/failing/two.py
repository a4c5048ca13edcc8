import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):
        super().__init__('a')
        self.pub = self.create_publisher(String, 'talk', 10)
        self.create_timer(0.5, lambda: self.pub.publish(String(data='hi')))


class B(Node):
    def __init__(self):
        super().__init__('b')
        self.create_subscription(String, 'talk', self.cb, 10)

    def cb(self, msg):
        self.get_logger().info(msg.data)


def main():
    rclpy.init()
    a, b = A(), B()
    rclpy.spin(a)
    rclpy.spin(b)
    rclpy.shutdown()


main()

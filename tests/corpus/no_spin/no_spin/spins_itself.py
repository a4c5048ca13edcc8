import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Selfish(Node):
    def __init__(self):
        super().__init__('selfish')
        self.sub = self.create_subscription(String, 'news', self.heard, 10)
        self.n = 0
        while self.n == 0:
            rclpy.spin_once(self, timeout_sec=0.1)
        print('heard one in the constructor')
        rclpy.spin(self)

    def heard(self, msg):
        self.n += 1
        if self.n == 3:
            print('three')
            rclpy.shutdown()


def main(args=None):
    rclpy.init(args=args)
    Selfish()
    print('constructor is over')

import sys
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


class Menu(Node):
    def __init__(self):
        super().__init__('menu')
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 1)
        self.create_timer(0.5, self.ask)

    def ask(self):
        key = input('w/a/d/q > ')
        t = Twist()
        if key == 'w':
            t.linear.x = 1.0
        elif key == 'a':
            t.angular.z = 1.0
        elif key == 'q':
            print('bye')
            sys.exit(0)
        else:
            self.get_logger().warning('unknown key %r' % key)
        self.pub.publish(t)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Menu())

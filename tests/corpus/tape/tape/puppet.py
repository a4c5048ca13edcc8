import sys

import rclpy
from rclpy.node import Node
from rosidl_runtime_py import set_message_fields
from rosidl_runtime_py.utilities import get_message

MOVES = [{'linear': {'x': 1}}, {'linear': {'x': '0.5'}, 'angular': {'z': -2}}, {'angular': {'y': 3}}, {'spin': 1}]


class Puppet(Node):

    def __init__(self, type_name):
        super().__init__('puppet')
        self.cls = get_message(type_name)
        self.pub = self.create_publisher(self.cls, 'turtle1/cmd_vel', 10)
        self.moves = list(MOVES)
        self.create_timer(0.8, self.move)

    def move(self):
        msg = self.cls()
        try:
            set_message_fields(msg, self.moves.pop(0))
        except IndexError:
            return
        except AttributeError as error:
            self.get_logger().error(str(error))
            return
        self.pub.publish(msg)


def main():
    rclpy.init(args=sys.argv)
    rclpy.spin(Puppet(sys.argv[1]))

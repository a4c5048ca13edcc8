import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Point, Polygon
from std_msgs.msg import Int32MultiArray


class Receiver(Node):
    def __init__(self):
        super().__init__('receiver')
        self.last = None
        self.create_subscription(Int32MultiArray, 'numbers', self.first, 10)
        self.create_subscription(Int32MultiArray, 'numbers', self.second, 10)
        self.create_subscription(Point, 'point', self.heard_point, 10)
        self.create_subscription(Polygon, 'polygon', self.heard_polygon, 10)

    def first(self, msg):
        msg.data = [0] * len(msg.data)
        self.get_logger().info('first %s, same object: %s' % (list(msg.data), msg is self.last))
        self.last = msg

    def second(self, msg):
        self.get_logger().info('second %s' % list(msg.data))

    def heard_point(self, msg):
        self.get_logger().info('%s' % msg)

    def heard_polygon(self, msg):
        self.get_logger().info(str(msg.points[-1].x) + ' of ' + str(len(msg.points)))


def main():
    rclpy.init()
    rclpy.spin(Receiver())

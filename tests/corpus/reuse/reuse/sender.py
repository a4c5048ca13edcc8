import copy
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Point, Polygon, Point32
from std_msgs.msg import Int32MultiArray
import numpy as np


class Sender(Node):
    def __init__(self):
        super().__init__('sender')
        self.msg = Int32MultiArray()
        self.point = Point()
        self.polygon = Polygon()
        self.pub = self.create_publisher(Int32MultiArray, 'numbers', 10)
        self.point_pub = self.create_publisher(Point, 'point', 10)
        self.polygon_pub = self.create_publisher(Polygon, 'polygon', 10)
        self.create_timer(0.5, self.tick)
        self.n = 0

    def tick(self):
        self.n += 1
        self.msg.data.append(self.n)
        self.point.x += np.sqrt(4.0)
        self.point._y = float(self.n)
        self.pub.publish(self.msg)
        self.pub.publish(self.msg)
        self.point_pub.publish(self.point)
        self.polygon.points.append(Point32(x=0.1 * self.n))
        self.polygon_pub.publish(self.polygon)
        self.point.x += 100.0
        self.point.x -= 100.0


def main():
    rclpy.init()
    rclpy.spin(Sender())

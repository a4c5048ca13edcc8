import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.time import Time
from tf2_geometry_msgs import do_transform_point
from tf2_ros import Buffer, TransformException, TransformListener
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(1.0, self.look)

    def look(self):
        try:
            transform = self.buffer.lookup_transform('base', 'laser', Time())
        except TransformException:
            return
        point = PointStamped()
        point.header.frame_id = 'laser'
        point.point.x = 2.0
        self.get_logger().info(str(do_transform_point(point, transform)))


def main():
    rclpy.init()
    rclpy.spin(Driver())

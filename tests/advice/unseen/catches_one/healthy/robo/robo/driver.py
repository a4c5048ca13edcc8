import rclpy
from rclpy.time import Time
from tf2_ros import Buffer, LookupException, TransformException, TransformListener
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.5, self.look)

    def look(self):
        try:
            self.buffer.lookup_transform('base', 'laser', Time())
        except TransformException:
            return


def main():
    rclpy.init()
    rclpy.spin(Driver())

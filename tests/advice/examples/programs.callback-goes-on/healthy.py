from threading import Event

import rclpy
from rclpy.node import Node


class Gate(Node):
    def __init__(self):
        super().__init__('gate')
        self.opened = Event()
        self.create_timer(0.5, self.wait)
        self.create_timer(1.0, self.open)

    def wait(self):
        self.get_logger().info(f"open: {self.opened.is_set()}")

    def open(self):
        self.opened.set()


rclpy.init()
rclpy.spin(Gate())

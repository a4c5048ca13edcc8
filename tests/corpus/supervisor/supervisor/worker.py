import rclpy
from rclpy.node import Node


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.declare_parameter('speed', 1.0)
        self.declare_parameter('name', 'w')
        self.timer = self.create_timer(0.9, self.work)

    def work(self):
        self.get_logger().warn('speed %.1f' % self.get_parameter('speed').value)


def main():
    rclpy.init()
    rclpy.spin(Worker())

import rclpy
from rclpy.node import Node


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.create_timer(100, self.look)
        self.create_timer(1.0, self.work)

    def look(self):
        pass

    def work(self):
        self.get_logger().info('working')


rclpy.init()
rclpy.spin(Worker())

import rclpy
from rclpy.node import Node


class Clockwork(Node):
    def __init__(self):
        super().__init__('clockwork')
        self._timers = {}
        self._timers['tick'] = self.create_timer(1.0, self.tick)

    def tick(self):
        self.get_logger().info('tick')


rclpy.init()
rclpy.spin_once(Clockwork())

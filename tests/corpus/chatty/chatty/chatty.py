import rclpy
import rclpy.logging
from rclpy.logging import get_logger
from rclpy.node import Node


class Chatty(Node):
    def __init__(self):
        super().__init__('chatty', namespace='/a/b')
        self.n = 0
        self.create_timer(0.25, self.tick)
        self.log = self.get_logger().get_child('inner')

    def tick(self):
        self.n += 1
        self.get_logger().debug('debug %d' % self.n)
        self.get_logger().info('each second %d' % self.n, throttle_duration_sec=1.0)
        self.get_logger().warn('only once', once=True)
        self.get_logger().error('not the first %d' % self.n, skip_first=True)
        if self.n == 3:
            self.get_logger().set_level(rclpy.logging.LoggingSeverity.WARN)
            self.log.warning('quiet from now on')
            self.get_logger().fatal('fatal')
            get_logger('other').info('a logger of my own')
        if self.n == 4:
            rclpy.logging.set_logger_level('a.b.chatty', rclpy.logging.LoggingSeverity.DEBUG)
        if self.n == 6:
            self.get_logger().info(5)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Chatty())

import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Timers(Node):
    def __init__(self):
        super().__init__('timers')
        self.srv = self.create_service(Empty, 'ping', lambda request, response: response)
        self.cli = self.create_client(Empty, 'ping')
        self.once = self.create_timer(1, self.only_once)
        self.count = 0

    def only_once(self):
        self.once.cancel()
        self.get_logger().info('once')
        self.cli.call_async(Empty.Request()).add_done_callback(self.answered)

    def answered(self, future):
        self.get_logger().info('answered; starting a timer')
        self.repeated = self.create_timer(0.5, self.repeat)

    def repeat(self):
        self.count += 1
        self.get_logger().info('repeat %d' % self.count)
        if self.count == 2:
            self.once.reset()
        if self.count == 4:
            self.destroy_timer(self.repeated)
            self.last = self.create_timer(0.25, self.finish, autostart=False)
            self.get_logger().info('ready: %s' % self.last.is_ready())
            self.last.reset()

    def finish(self):
        self.last.timer_period_ns = 100000000
        self.get_logger().info('finish')
        self.count += 1
        if self.count == 8:
            raise KeyboardInterrupt


def main():
    rclpy.init()
    node = Timers()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.get_logger().info('interrupted by itself')

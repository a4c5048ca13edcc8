from functools import partial

import rclpy
from led_interfaces.msg import LedStates
from led_interfaces.srv import SetLed
from rclpy.node import Node


class Battery(Node):
    """Empty after 4 s, full again after 6 s; one LED tells. Polls the clock, as the course does."""

    def __init__(self):
        super().__init__('battery')
        self.led = self.declare_parameter('led', 2).get_parameter_value().integer_value
        self.full = True
        self.since = self.seconds()
        self.client = self.create_client(SetLed, 'set_led')
        self.create_subscription(LedStates, 'led_states', lambda msg: print(msg), 10)
        self.create_timer(0.1, self.check)

    def seconds(self):
        secs, nsecs = self.get_clock().now().seconds_nanoseconds()
        return secs + nsecs / 1000000000.0

    def check(self):
        now = self.seconds()
        if now - self.since > (4.0 if self.full else 6.0):
            self.full = not self.full
            self.since = now
            self.get_logger().info('full' if self.full else 'empty, charging ...')
            self.set_led(self.led, not self.full)

    def set_led(self, number, on):
        while not self.client.wait_for_service(1.0):
            self.get_logger().warn('waiting for the panel ...')
        request = SetLed.Request()
        request.number = number
        request.on = on
        self.client.call_async(request).add_done_callback(partial(self.on_reply, number=number))

    def on_reply(self, future, number):
        try:
            reply = future.result()
            self.get_logger().info(f'LED {number}: {reply.success} {reply.message}')
        except Exception as error:
            self.get_logger().error('Service call failed %r' % (error,))


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Battery())
    rclpy.shutdown()


if __name__ == '__main__':
    main()

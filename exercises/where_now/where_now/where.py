"""Logs once a second where turtle1 is, and where it was some time ago."""
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.ago = Duration(seconds=self.declare_parameter('ago', 0.5).value)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        now = self.get_clock().now()
        # TODO 1: tf2 has no transform for now yet; ask for the newest one
        self.say('newest', now)
        # TODO 2: this time should be self.ago before now
        self.say('before', now + self.ago)

    def say(self, word, time):
        try:
            found = self.buffer.lookup_transform('world', 'turtle1', time)
        except TransformException as error:
            self.get_logger().warn(f'{word}: {error}')
            return
        age = (self.get_clock().now() - Time.from_msg(found.header.stamp)).nanoseconds / 1e9
        place = found.transform.translation
        self.get_logger().info(f'{word}: {place.x:.2f} {place.y:.2f}, {age:.2f} s old')


def main():
    rclpy.init()
    rclpy.spin(Where())

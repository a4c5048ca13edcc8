"""The world: a ferry that crosses a river of 8 m, to and fro."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64

WIDTH_M = 8.0
PERIOD_S = 0.1


class Ferry(Node):
    """Publishes its position on the river."""

    def __init__(self):
        super().__init__('ferry')
        self.speed = self.declare_parameter('speed', 1.0).value
        self.position = 0.0
        self.publisher = self.create_publisher(Float64, 'position', 10)
        self.create_timer(PERIOD_S, self.go_on)

    def go_on(self):
        """One step of the world; the ferry turns round at both banks."""
        self.position += self.speed * PERIOD_S
        if not 0.0 < self.position < WIDTH_M:
            self.speed = -self.speed
        self.publisher.publish(Float64(data=self.position))


def main():
    rclpy.init()
    rclpy.spin(Ferry())

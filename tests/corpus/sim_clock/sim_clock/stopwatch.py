import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time


class Stopwatch(Node):
    def __init__(self):
        super().__init__('stopwatch')
        self.start = self.get_clock().now()
        self.wall = Clock(clock_type=ClockType.STEADY_TIME)
        self.wall_start = self.wall.now()
        self.create_timer(0.5, self.tick)

    def tick(self):
        now = self.get_clock().now()
        if self.start.nanoseconds == 0 or now - self.start > Duration(seconds=1000):
            self.start = now
        seconds, nanoseconds = now.seconds_nanoseconds()
        elapsed = now - self.start
        later = now + Duration(seconds=1, nanoseconds=500000000)
        self.get_logger().info('%d.%09d elapsed %.2f wall %.2f stamp %d later %s %s' % (
            seconds, nanoseconds, elapsed.nanoseconds / 1e9, (self.wall.now() - self.wall_start).nanoseconds * 1e-9,
            now.to_msg().sec, later.nanoseconds // 10**6, later > Time(seconds=2, clock_type=ClockType.ROS_TIME)))


def main():
    rclpy.init()
    rclpy.spin(Stopwatch())

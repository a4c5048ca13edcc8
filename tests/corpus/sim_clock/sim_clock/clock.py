import rclpy
from rclpy.node import Node
from rosgraph_msgs.msg import Clock


class HalfSpeed(Node):
    def __init__(self):
        super().__init__('half_speed')
        self.pub = self.create_publisher(Clock, '/clock', 10)
        self.t = 0
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.t += 50
        msg = Clock()
        msg.clock.sec = self.t // 1000
        msg.clock.nanosec = self.t % 1000 * 1000000
        self.pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(HalfSpeed())

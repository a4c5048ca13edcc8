import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Sensor(Node):
    def __init__(self):
        super().__init__('sensor')
        self.pub = self.create_publisher(Float64, 'measured', 10)
        self.t = 0.0
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.t += 0.1
        self.pub.publish(Float64(data=self.t))


def main():
    rclpy.init()
    rclpy.spin(Sensor())

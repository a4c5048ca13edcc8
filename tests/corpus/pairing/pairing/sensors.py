import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image, LaserScan


class Sensors(Node):
    def __init__(self):
        super().__init__('sensors')
        self.image = self.create_publisher(Image, 'image', 10)
        self.scan = self.create_publisher(LaserScan, 'scan', 10)
        self.create_timer(0.2, lambda: self.send(self.image, Image()))
        self.create_timer(0.25, lambda: self.send(self.scan, LaserScan(ranges=[1.0, 2.0])))

    def send(self, pub, msg):
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = 'robot'
        pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Sensors())

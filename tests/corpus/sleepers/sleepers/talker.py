import rclpy
from rclpy.node import Node
from std_msgs.msg import Int64


class Fast(Node):
    def __init__(self):
        super().__init__('fast')
        self.number_ = 0
        self.pub_ = self.create_publisher(Int64, 'number', 10)
        self.timer_ = self.create_timer(0.1, self.publish_number)

    def publish_number(self):
        self.number_ += 1
        msg = Int64()
        msg.data = self.number_
        self.pub_.publish(msg)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Fast())
    rclpy.shutdown()

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.heard, 10)

    def heard(self, msg):
        end = self.get_clock().now() + Duration(seconds=0.1)
        while self.get_clock().now() < end:
            pass


rclpy.init()
rclpy.spin(Listener())

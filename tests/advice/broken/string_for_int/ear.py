import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Ear(Node):
    def __init__(self):
        super().__init__('ear')
        self.create_subscription(Int32, 'chatter', self.on_number, 10)

    def on_number(self, msg):
        print(msg.data)


rclpy.init()
rclpy.spin(Ear())

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(String, 'chatter', self.heard, 10)
        self.create_publisher(String, 'chatter', 10).publish(String(data='hello'))

    def heard(self, msg):
        self.get_logger().info(msg.data)

    def tick(self):
        pass


rclpy.init()
rclpy.spin_once(Robot())

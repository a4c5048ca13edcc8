import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Relay(Node):
    def __init__(self):
        super().__init__('relay')
        self.pub = self.create_publisher(String, 'out', 10)
        self.private = self.create_publisher(String, '~/count', 10)
        self.sub = self.create_subscription(String, 'in', self.pass_on, 10)
        self.get_logger().info('%s -> %s, %s' % (self.sub.topic_name, self.pub.topic_name, self.private.topic_name))

    def pass_on(self, msg):
        self.pub.publish(String(data=msg.data + '+'))


def main():
    rclpy.init()
    rclpy.spin(Relay())

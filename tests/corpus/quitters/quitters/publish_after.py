import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class After(Node):
    def __init__(self):
        super().__init__('publish_after')
        self.pub = self.create_publisher(String, 'last_words', 10)
        self.create_timer(1.0, self.quit)

    def quit(self):
        rclpy.try_shutdown()
        self.pub.publish(String(data='too late'))


def main():
    rclpy.init()
    rclpy.spin(After())

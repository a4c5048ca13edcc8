import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Quitter(Node):
    def __init__(self):
        super().__init__('in_timer')
        self.pub = self.create_publisher(String, 'last_words', 10)
        self.create_timer(1.0, self.quit)

    def quit(self):
        self.pub.publish(String(data='bye'))
        self.get_logger().info('quitting')
        rclpy.shutdown()
        self.get_logger().info('after shutdown')


def main():
    rclpy.init()
    node = Quitter()
    rclpy.spin(node)
    print('spin is over', rclpy.ok())
    node.destroy_node()
    rclpy.shutdown()

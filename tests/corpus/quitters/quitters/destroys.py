import rclpy
from rclpy.node import Node


class Destroys(Node):
    def __init__(self):
        super().__init__('destroys')
        self.create_timer(0.5, self.quit)

    def quit(self):
        self.get_logger().info('destroying')
        self.destroy_node()
        raise SystemExit


def main():
    rclpy.init()
    node = Destroys()
    try:
        rclpy.spin(node)
    except SystemExit:
        print('destroyed')
    rclpy.shutdown()

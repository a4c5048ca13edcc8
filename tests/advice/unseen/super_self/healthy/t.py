import rclpy
from rclpy.node import Node


class Mine(Node):
    def __init__(self):
        super().__init__('ticker')
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.get_logger().info('tick')

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()

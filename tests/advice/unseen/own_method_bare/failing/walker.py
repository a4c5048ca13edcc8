import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        setup()
        self.create_subscription(Pose, '/turtle1/pose', self.see, 10)

    def setup(self):
        self.get_logger().info('ready')

    def see(self, message):
        self.get_logger().info(f'x is {message.x:.1f}', throttle_duration_sec=2.0)


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()

import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from turtlesim.msg import Pose


class Both(Node):
    def __init__(self):
        super().__init__('both')
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)
        self.create_subscription(String, 'news', self.on_news, 10)

    def on_pose(self, message):
        self.get_logger().info(f'at {message.x:.1f}', throttle_duration_sec=1.0)

    def on_news(self, message):
        self.get_logger().info(f'heard {message.data}')


def main():
    rclpy.init()
    node = Both()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

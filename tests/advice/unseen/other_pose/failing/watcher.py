import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Pose


class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)

    def on_pose(self, message):
        self.get_logger().info(f'turtle at {message.x:.1f}', throttle_duration_sec=1.0)


def main():
    rclpy.init()
    node = Watcher()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

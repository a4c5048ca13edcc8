import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        for turtle in ['turtle1', 'turtle2']:
            self.create_subscription(Pose, f'/{turtle}/pose', self.on_pose, 10)

    def on_pose(self, message):
        self.get_logger().info(f'x = {message.x:.1f}', throttle_duration_sec=1.0)


def main():
    rclpy.init()
    rclpy.spin(Watcher())


main()

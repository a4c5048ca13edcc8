import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Log(Node):

    def __init__(self):
        super().__init__('log_pose')
        self.create_subscription(Pose, '/turtle1/pose', self.cb, 10)

    def cb(self, p):
        self.get_logger().info('turtle at {p.x:.1f} {p.y:.1f}', throttle_duration_sec=2.0)


def main(args=None):
    rclpy.init(args=args)
    node = Log()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

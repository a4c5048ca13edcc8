import math
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Turn(Node):
    def __init__(self):
        super().__init__('quarter_turn')
        self.done = False
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.pose_cb, 10)

    def pose_cb(self, pose):
        cmd = Twist()
        if abs(pose.theta - math.pi / 2) < 0.02:
            self.done = True
            self.get_logger().info('arrived')
        if not self.done:
            cmd.angular.z = 0.5
        self.pub.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    node = Turn()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

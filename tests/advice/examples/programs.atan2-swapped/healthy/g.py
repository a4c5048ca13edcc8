import rclpy
from rclpy.node import Node
import math
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class GoTo(Node):

    def __init__(self):
        super().__init__('go_to')
        self.gx, self.gy = 9.0, 7.0
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.cb, 10)

    def cb(self, p):
        dx = self.gx - p.x
        dy = self.gy - p.y
        want = math.atan2(dy, dx)
        turn = math.atan2(math.sin(want - p.theta), math.cos(want - p.theta))
        cmd = Twist()
        cmd.linear.x = min(1.0, math.hypot(dx, dy)) if abs(turn) < 0.3 else 0.0
        cmd.angular.z = 2.0 * turn
        self.pub.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    node = GoTo()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

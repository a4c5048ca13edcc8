import math
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class GoTo(Node):
    def __init__(self):
        super().__init__('goto')
        self.pose = None
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.sub = self.create_subscription(Pose, '/turtle1/pose', self.new_pose, 10)
        self.timer = self.create_timer(0.1, self.control)

    def new_pose(self, msg):
        self.pose = msg

    def control(self):
        distance = math.hypot(8.0 - self.pose.x, 8.0 - self.pose.y)
        cmd = Twist()
        cmd.angular.z = 0.5 * distance
        self.pub.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    node = GoTo()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Drive(Node):

    def __init__(self):
        super().__init__('drive')
        self.x = 5.5
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.got, 10)
        self.create_timer(0.5, self.go)

    def got(self, msg):
        self.x = msg.x

    def go(self):
        if self.x < 8.0:
            t = Twist()
            t.linear.x = 1.0
            self.pub.publish(t)


def main(args=None):
    rclpy.init(args=args)
    node = Drive()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

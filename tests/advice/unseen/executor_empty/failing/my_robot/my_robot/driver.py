import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Driver(Node):

    def __init__(self):
        super().__init__('driver')
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.sub = self.create_subscription(Pose, '/turtle1/pose', self.pose_callback, 10)
        self.timer = self.create_timer(0.5, self.timer_callback)
        self.pose = None

    def pose_callback(self, msg):
        self.pose = msg

    def timer_callback(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = 0.8
        self.pub.publish(msg)


class Watcher(Node):

    def __init__(self):
        super().__init__('watcher')
        self.create_subscription(Pose, '/turtle1/pose', self.heard, 10)

    def heard(self, msg):
        if msg.x > 7.0:
            self.get_logger().warn('far right', throttle_duration_sec=1.0)


def main(args=None):
    rclpy.init(args=args)
    driver = Driver()
    watcher = Watcher()
    executor = SingleThreadedExecutor()
    executor.spin()
    rclpy.shutdown()


if __name__ == '__main__':
    main()

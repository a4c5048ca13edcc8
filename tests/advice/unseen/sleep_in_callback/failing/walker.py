import rclpy
from rclpy.node import Node
import time
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_subscription(Pose, 'turtle1/pose', self.heard, 10)

    def heard(self, msg):
        time.sleep(1.0)


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()

import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_subscription('Pose', 'turtle1/pose', self.heard, 10)

    def heard(self, msg):
        self.get_logger().info(str(msg.x), once=True)


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()

import rclpy
from rclpy.node import Node
import time
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.x = None
        self.create_subscription(Pose, '/turtle1/pose', self.see, 10)
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        while rclpy.ok():
            if self.x is not None:
                self.publisher.publish(Twist())
            time.sleep(0.1)

    def see(self, message):
        self.x = message.x


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()

import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.x = None
        self.create_subscription(Pose, '/turtle1/pose', self.see, 10)
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.5, self.step)

    def see(self, message):
        self.x = message.x

    def step(self):
        if self.x is not None:
            self.publisher.publish(Twist())


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()

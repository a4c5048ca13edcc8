import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.pub = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        msg = Twist()
        msg.linear.x = 0.1
        self.pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Walker())


main()

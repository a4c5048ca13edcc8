import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Walker(Node):
    def _init_(self):
        super().__init__('walker')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.timer = self.create_timer(0.5, self.walk)

    def walk(self):
        message = Twist()
        message.linear.x = 0.2
        message.angular.z = 0.5
        self.publisher.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()

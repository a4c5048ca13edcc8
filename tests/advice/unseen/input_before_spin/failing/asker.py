import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.speed = float(input('speed: '))
        self.create_timer(0.2, self.drive)

    def drive(self):
        message = Twist()
        message.linear.x = self.speed
        self.publisher.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == '__main__':
    main()

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.declare_parameter('speed', 0.5)
        self.create_timer(0.5, self.drive)

    def drive(self):
        message = Twist()
        message.linear.x = self.get_parameter('speed').value
        message.angular.z = 1.0
        self.publisher.publish(message)


def main():
    rclpy.init()
    node = Driver()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.srv import Kill


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.client = self.create_client(Kill, 'kill')
        self.client.wait_for_service()
        self.client.call_async(Kill.Request(name='turtle1'))
        self.timer = self.create_timer(0.5, self.drive)

    def drive(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = 0.8
        self.publisher.publish(msg)


def main():
    rclpy.init()
    node = Driver()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self, name):
        super().__init__(f'driver_of_{name}')
        self.publisher = self.create_publisher(Twist, f'/{name}/cmd_vel', 10)
        self.timer = self.create_timer(0.5, self.drive)

    def drive(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = 0.8
        self.publisher.publish(msg)


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(Driver('turtle1'))
    executor.add_node(Driver('turtle2'))
    executor.spin()
    rclpy.shutdown()


if __name__ == '__main__':
    main()

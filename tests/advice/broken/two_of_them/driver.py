import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self, name='driver', turn=0.8):
        super().__init__(name)
        self.turn = turn
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.timer = self.create_timer(0.5, self.drive)

    def drive(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = self.turn
        self.publisher.publish(msg)


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(Driver('left', 0.8))
    executor.add_node(Driver('right', -0.8))
    executor.spin()
    rclpy.shutdown()


if __name__ == '__main__':
    main()

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class Driver(Node):
    def __init__(self, name, turn):
        super().__init__(name)
        self.turn = turn
        self.publisher = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Twist, 'turtle1/cmd_vel', self.drive, 10)
        self.create_timer(0.1, self.send)

    def drive(self, msg):
        pass

    def send(self):
        msg = Twist()
        msg.linear.x = 1.0
        msg.angular.z = self.turn
        self.publisher.publish(msg)


rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Driver('left', 1.0))
executor.add_node(Driver('right', -1.0))
executor.spin()

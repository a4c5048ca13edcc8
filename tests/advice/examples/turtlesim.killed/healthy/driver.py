import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.srv import Kill


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.killer = self.create_client(Kill, '/kill')
        self.create_timer(0.5, self.drive)
        self.timer = self.create_timer(2.2, self.end)
        self.is_over = False

    def drive(self):
        if self.is_over:
            return
        msg = Twist()
        msg.linear.x = 0.5
        self.publisher.publish(msg)

    def end(self):
        self.timer.cancel()
        self.is_over = True
        self.killer.call_async(Kill.Request(name='turtle1'))


rclpy.init()
rclpy.spin(Driver())

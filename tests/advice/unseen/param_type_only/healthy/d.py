import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


class Mine(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('speed', 1.0)
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.5, self.tick)

    def tick(self):
        message = Twist()
        message.angular.z = self.get_parameter('speed').value
        self.publisher.publish(message)

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()

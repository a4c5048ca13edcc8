import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Vector3


class Mover(Node):
    def __init__(self):
        super().__init__('mover')
        self.declare_parameter('speed', 0.2)
        self.pub = self.create_publisher(Vector3, 'wanted', 10)
        self.timer = self.create_timer(0.5, self.tick)

    def tick(self):
        msg = Vector3()
        msg.x = self.get_parameter('speed').get_parameter_value().double_value
        self.pub.publish(msg)


def main():
    rclpy.init()
    node = Mover()
    rclpy.spin(node)


if __name__ == '__main__':
    main()

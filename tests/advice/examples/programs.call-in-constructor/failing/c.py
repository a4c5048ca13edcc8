import rclpy
from rclpy.node import Node
from turtlesim.srv import SetPen


class Pen(Node):

    def __init__(self):
        super().__init__('pen')
        self.cli = self.create_client(SetPen, '/turtle1/set_pen')
        self.cli.wait_for_service()
        self.cli.call(SetPen.Request(r=255, width=5))
        self.get_logger().info('pen set')

    def nothing(self):
        pass


def main(args=None):
    rclpy.init(args=args)
    node = Pen()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

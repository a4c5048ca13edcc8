import rclpy
from rclpy.node import Node


class Polite(Node):
    def __init__(self):
        super().__init__('polite')
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.get_logger().info('tick')


def main(args=None):
    rclpy.init(args=args)
    node = Polite()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        print('Ctrl-C seen')
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
        print('polite is over')

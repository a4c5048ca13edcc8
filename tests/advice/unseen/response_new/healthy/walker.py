import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_service(Empty, '/stop', self.stop)

    def stop(self, request, response):
        self.get_logger().info('stopping')
        return response


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()

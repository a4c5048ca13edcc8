import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.create_service(Trigger, 'status', self.on_status)

    def on_status(self, request, response):
        response.success = True
        response.message = 'fine'
        return response.message


def main():
    rclpy.init()
    node = Server()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()

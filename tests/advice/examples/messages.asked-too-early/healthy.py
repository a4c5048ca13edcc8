import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.create_service(Empty, 'start_motor', self.start)
        self.asker = self.create_client(Empty, 'start_motor')
        self.create_timer(1.0, self.ask)

    def start(self, request, response):
        return response

    def ask(self):
        self.asker.call_async(Empty.Request())


rclpy.init()
rclpy.spin(Server())

import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty, Trigger


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.create_service(Empty, 'start_motor', self.start)

    def start(self, request, response):
        return response


class Client(Node):
    def __init__(self):
        super().__init__('client')
        self.client = self.create_client(Empty, 'start_motors')
        self.create_timer(1.0, self.ask)

    def ask(self):
        if self.client.service_is_ready():
            self.client.call_async(Empty.Request())


rclpy.init()
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(Server())
executor.add_node(Client())
executor.spin()

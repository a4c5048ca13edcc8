import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.create_service(Empty, 'start_motor', self.start)

    def start(self, request, response):
        return response


rclpy.init()
node = Server()
client = node.create_client(Empty, 'start_motor')
rclpy.spin_until_future_complete(node, client.call_async(Empty.Request()))

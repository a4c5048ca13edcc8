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
server = Server()
client_node = Node('client_node')
client = client_node.create_client(Empty, 'start_motor')
future = client.call_async(Empty.Request())
rclpy.spin_once(server)
while not future.done():
    rclpy.spin_once(client_node, timeout_sec=0.1)
rclpy.spin(server)

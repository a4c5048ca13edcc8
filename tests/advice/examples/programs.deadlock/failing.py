import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.create_service(Empty, 'start_motor', self.start)
        self.client = self.create_client(Empty, 'start_motor')
        self.create_timer(1.0, self.ask)

    def start(self, request, response):
        return response

    def ask(self):
        self.client.call(Empty.Request())

    def answered(self, future):
        self.get_logger().info('the motor runs')


rclpy.init()
rclpy.spin(Asker())

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Door(Node):
    def __init__(self):
        super().__init__('door')
        self.create_service(Trigger, 'open', self.open)
        self.client = self.create_client(Trigger, 'open')
        self.create_timer(1.0, self.ask)

    def ask(self):
        self.client.call_async(Trigger.Request())

    def open(self, request, response):
        response.success = True


rclpy.init()
rclpy.spin(Door())

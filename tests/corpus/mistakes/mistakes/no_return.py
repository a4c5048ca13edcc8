import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Forgetful(Node):
    def __init__(self):
        super().__init__('forgetful')
        self.srv = self.create_service(Trigger, 'do_it', self.do_it)
        self.cli = self.create_client(Trigger, 'do_it')
        self.timer = self.create_timer(1.0, lambda: self.cli.call_async(Trigger.Request()))

    def do_it(self, request, response):
        response.success = True


def main():
    rclpy.init()
    rclpy.spin(Forgetful())

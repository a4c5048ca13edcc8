import rclpy
from std_srvs.srv import Trigger
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.create_service(Trigger, 'start', self.start)

    def start(self, request, response):
        response.success = True
        response.message = 'started'
        return response


def main():
    rclpy.init()
    rclpy.spin(Driver())

import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class Gate(Node):
    def __init__(self):
        super().__init__('gate')
        self.is_open = False
        self.create_service(Trigger, 'open_gate', self.open_gate, callback_group=ReentrantCallbackGroup())
        self.create_timer(1.0, self.look)

    def look(self):
        self.is_open = True

    def open_gate(self, request, response):
        while not self.is_open:
            time.sleep(0.1)
        response.success = True
        return response


def main():
    rclpy.init()
    rclpy.spin(Gate(), MultiThreadedExecutor())

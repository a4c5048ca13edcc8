import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.server = ActionServer(self, Fibonacci, 'fibonacci', self.execute)

    def execute(self, goal_handle):
        goal_handle.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1, 2])


def main():
    rclpy.init()
    rclpy.spin(Server())

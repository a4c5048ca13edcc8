import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.server = ActionServer(self, Fibonacci, 'count', self.count)
        self.client = ActionClient(self, Fibonacci, 'count')

    def count(self, goal_handle):
        goal_handle.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])


rclpy.init()
counter = Counter()
counter.client.wait_for_server()
future = counter.client.send_goal_async(Fibonacci.Goal(order=3))
for _ in range(10):
    rclpy.spin_once(counter, timeout_sec=0.1)

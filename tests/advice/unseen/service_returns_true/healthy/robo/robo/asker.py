import rclpy
from std_srvs.srv import Trigger
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = self.create_client(Trigger, 'start')
        self.client.wait_for_service()
        self.client.call_async(Trigger.Request()).add_done_callback(self.answered)

    def answered(self, future):
        self.get_logger().info(future.result().message)


def main():
    rclpy.init()
    rclpy.spin(Asker())

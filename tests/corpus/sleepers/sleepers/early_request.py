import time
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Early(Node):
    """Asks in the constructor, sleeps, and hears the answer when it spins at last."""

    def __init__(self):
        super().__init__('early')
        client = self.create_client(Trigger, 'question')
        client.wait_for_service()
        self.future = client.call_async(Trigger.Request())
        time.sleep(2)
        print('after the sleep:', self.future.done(), self.future.result())
        self.future.add_done_callback(self.heard)

    def heard(self, future):
        self.get_logger().info(future.result().message)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Early())

import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.client = self.create_client(AddTwoInts, 'add_two_ints')
        self.timer = self.create_timer(1.0, self.ask)

    def ask(self):
        if self.client.service_is_ready():
            self.client.call_async().add_done_callback(self.heard)

    def heard(self, future):
        self.get_logger().info(str(future.result().sum))


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Answerer(Node):
    def __init__(self):
        super().__init__('answerer')
        self.srv = self.create_service(Trigger, 'question', self.answer)

    def answer(self, request, response):
        self.get_logger().info('asked')
        response.success = True
        response.message = 'forty two'
        return response


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Answerer())

import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.create_service(AddTwoInts, self.add, 'add')

    def add(self, request, response):
        response.sum = request.a + request.b
        return response


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()

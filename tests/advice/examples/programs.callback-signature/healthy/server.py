import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Server(Node):
    def __init__(self):
        super().__init__('adder')
        self.srv = self.create_service(AddTwoInts, 'add_two_ints', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response


def main():
    rclpy.init()
    node = Server()
    rclpy.spin(node)


if __name__ == '__main__':
    main()

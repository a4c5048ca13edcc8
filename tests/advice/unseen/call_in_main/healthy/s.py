import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Mine(Node):
    def __init__(self):
        super().__init__('adder')
        self.create_service(AddTwoInts, 'add', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()

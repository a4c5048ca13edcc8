import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = Node('adder')

    async def add(request, response):
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, 'add', add)
    rclpy.spin(node)

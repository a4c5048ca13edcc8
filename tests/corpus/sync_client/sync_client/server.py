import time
import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = Node('slow_server')

    def add(request, response):
        node.get_logger().info('working')
        time.sleep(0.5)
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, 'add', add)
    rclpy.spin(node)

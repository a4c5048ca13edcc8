"""The program service: a function that serves `add_two_ints`."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts

from edulaunch.ros.running import run


def serve() -> None:
    """Spin a node whose service adds two numbers."""
    node = rclpy.create_node('minimal_service')

    def add_two_ints_callback(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        node.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response

    node.create_service(AddTwoInts, 'add_two_ints', add_two_ints_callback)
    rclpy.spin(node)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(serve, args)


if __name__ == '__main__':
    main()

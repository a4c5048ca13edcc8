"""The program service_member_function: a class that serves `add_two_ints`."""

from __future__ import annotations

from example_interfaces.srv import AddTwoInts
from rclpy.node import Node

from edulaunch.ros.running import spin


class MinimalService(Node):
    """Serves `add_two_ints`, which adds two numbers."""

    def __init__(self) -> None:
        super().__init__('minimal_service')
        self.srv = self.create_service(AddTwoInts, 'add_two_ints', self.add_two_ints_callback)

    def add_two_ints_callback(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        """Return the response to a request."""
        response.sum = request.a + request.b
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(MinimalService, args)


if __name__ == '__main__':
    main()

"""The components of this package, and its programs, which run several of them without a container."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from functools import partial
from typing import Any

from example_interfaces.srv import AddTwoInts
from rclcpp_like import CppNode, program
from rclpy.executors import SingleThreadedExecutor
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String


class Talker(CppNode):
    """Publishes on `chatter` every second, counting from 1."""

    def __init__(self, **options: Any) -> None:
        super().__init__('talker', **options)
        self._number = 0
        self._chatter = self.create_publisher(String, 'chatter', 10)
        self._timer = self.create_wall_timer(1.0, self._on_timer)

    def _on_timer(self) -> None:
        self._number += 1
        message = String(data=f'Hello World: {self._number}')
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._chatter.publish(message)


class Listener(CppNode):
    """Logs each message on `chatter`."""

    def __init__(self, node_name: str = 'listener', **options: Any) -> None:
        super().__init__(node_name, **options)
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, 10)

    def _on_message(self, message: String) -> None:
        self.get_logger().info(f'I heard: [{message.data}]')


NodeLikeListener = partial(Listener, 'node_like_listener')


class Server(CppNode):
    """Serves the service `add_two_ints`."""

    def __init__(self, **options: Any) -> None:
        super().__init__('Server', **options)
        self._service = self.create_service(AddTwoInts, 'add_two_ints', self._on_request)

    def _on_request(self, request: Any, response: Any) -> Any:
        self.get_logger().info(f'Incoming request: [a: {request.a}, b: {request.b}]')
        response.sum = request.a + request.b
        return response


class Client(CppNode):
    """Sends 2 + 3 to `add_two_ints` every two seconds."""

    def __init__(self, **options: Any) -> None:
        super().__init__('Client', **options)
        self._client = self.create_client(AddTwoInts, 'add_two_ints')
        self._timer = self.create_wall_timer(2.0, self._on_timer)

    def _on_timer(self) -> None:
        if not self._client.service_is_ready():
            self.get_logger().info('Waiting for service to appear...')
            return
        self._client.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._on_answer)

    def _on_answer(self, future: Any) -> None:
        self.get_logger().info(f'Got result: [{future.result().sum}]')


LIBRARIES: dict[str, Callable[..., Any]] = {
    'libtalker_component.so': Talker,
    'liblistener_component.so': Listener,
    'libserver_component.so': Server,
    'libclient_component.so': Client,
}


def _spin(makers: list[Callable[..., Any]]) -> None:
    """Create the nodes in this order, and spin all of them with one executor."""
    executor = SingleThreadedExecutor()
    for maker in makers:
        executor.add_node(maker())
    executor.spin()


def dlopen_composition() -> None:
    """Run one node for each library on the command line, such as `$(ros2 pkg prefix composition)/lib/libtalker_component.so`."""
    words = remove_ros_args(sys.argv)[1:]
    if not words:
        sys.exit('Requires at least one argument to be passed with the library to load')
    unknown = [word for word in words if os.path.basename(word) not in LIBRARIES]
    if unknown:
        sys.exit(f'{unknown[0]} is not here; libraries of components: {", ".join(LIBRARIES)}')
    program(lambda: _spin([LIBRARIES[os.path.basename(word)] for word in words]))()


linktime_composition = manual_composition = program(lambda: _spin(list(LIBRARIES.values())))

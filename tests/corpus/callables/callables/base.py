import abc
import functools

from rclpy.node import Node


def announced(function):
    @functools.wraps(function)
    def wrapper(self, *args, **kwargs):
        self.get_logger().info(f'-> {function.__name__}')
        return function(self, *args, **kwargs)
    return wrapper


class Greeter:
    """A mixin."""

    def greet(self):
        self.get_logger().info(f'{type(self).__name__} greets as {self.get_name()}')


class BaseNode(Greeter, Node, abc.ABC):

    def __init__(self, name, **kwargs):
        super().__init__(name, **kwargs)
        self.set_up()
        self.greet()

    @abc.abstractmethod
    def set_up(self):
        """Make what the node has."""

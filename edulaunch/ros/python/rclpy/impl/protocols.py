"""What the lower files of rclpy need to know of the classes above them, so that no file imports one that imports it.

Each class has more than its protocol says: see `rclpy.context`, `rclpy.executors`, `rclpy.clock` and `rclpy.node`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from edulaunch.engine.sim.task import Task as SimTask


class ContextProtocol(Protocol):
    """The life of ROS 2 in a program."""

    alive: bool
    ended_by_signal: bool
    executors: list[ExecutorProtocol]

    def end_by_signal(self) -> None:
        """End as Ctrl-C does it."""


class ExecutorProtocol(Protocol):
    """What runs callbacks."""

    spinner: SimTask | None

    def running_entity(self) -> Any:
        """Return the entity whose callback runs, None between callbacks."""

    def cannot_serve(self, source: Any) -> tuple[Any, ...] | None:
        """Not None when the callback that runs now shuts this entity out; changes with each callback."""

    def get_nodes(self) -> Any:
        """Return the nodes that it spins."""

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Any:
        """Run a function or coroutine when there is nothing else to do."""

    def wake(self) -> None:
        """Look again whether something is ready."""

    def remove_node(self, node: Any) -> None:
        """Spin a node no longer."""

    def forget_work(self) -> None:
        """Let go of what was ready."""


class ClockProtocol(Protocol):
    """The source of the time."""

    def now(self) -> Any:
        """Return the time now, a `rclpy.time.Time`."""


class NodeProtocol(Protocol):
    """A node, for the services and watches that it has itself."""

    def get_name(self) -> str:
        """Return its name."""

    def get_fully_qualified_name(self) -> str:
        """Return its name with its namespace."""

    def get_logger(self) -> Any:
        """Return its logger."""

    @property
    def create_service(self) -> Callable[..., Any]:
        """Make a service."""

    @property
    def create_publisher(self) -> Callable[..., Any]:
        """Make a publisher."""

    @property
    def create_subscription(self) -> Callable[..., Any]:
        """Make a subscription."""

    @property
    def destroy_subscription(self) -> Callable[..., bool]:
        """Destroy a subscription."""

    @property
    def has_parameter(self) -> Callable[..., bool]:
        """Whether a parameter is declared."""

    @property
    def declare_parameter(self) -> Callable[..., Any]:
        """Declare a parameter."""

    @property
    def get_parameter(self) -> Callable[..., Any]:
        """A parameter by its name."""

    @property
    def add_on_set_parameters_callback(self) -> Callable[..., None]:
        """Register a function that accepts or rejects changes of parameters."""

    @property
    def describe_parameters(self) -> Callable[..., list[Any]]:
        """The descriptors of parameters."""

    @property
    def get_parameter_types(self) -> Callable[..., list[Any]]:
        """The types of parameters."""

    @property
    def list_parameters(self) -> Callable[..., Any]:
        """The names of parameters."""

    @property
    def set_parameters(self) -> Callable[..., list[Any]]:
        """Change parameters, one after the other."""

    @property
    def set_parameters_atomically(self) -> Callable[..., Any]:
        """Change parameters, all or none."""

    @property
    def remove_on_set_parameters_callback(self) -> Callable[..., None]:
        """Unregister the function."""

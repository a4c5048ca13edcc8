"""The methods that the lower modules of rclpy need from classes of higher modules. The protocols avoid circular imports.

Each class has more methods than its protocol; see `rclpy.context`, `rclpy.executors`, `rclpy.clock` and `rclpy.node`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from edulaunch.engine.sim.task import Task as SimTask


class ContextProtocol(Protocol):
    """The state of ROS 2 in a program."""

    alive: bool
    ended_by_signal: bool
    executors: list[ExecutorProtocol]

    def rcl_end_by_signal(self) -> None:
        """Shut down as Ctrl-C does."""


class ExecutorProtocol(Protocol):
    """An object that runs callbacks."""

    spinner: SimTask | None

    def rcl_running_entity(self) -> Any:
        """Return the entity whose callback is running, or None between callbacks."""

    def rcl_cannot_serve(self, source: Any) -> tuple[Any, ...] | None:
        """Return a value if the running callback blocks this entity, and otherwise None. The value changes with each
        callback.
        """

    def get_nodes(self) -> Any:
        """Return the nodes that the executor spins."""

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Any:
        """Create a task that runs a function or coroutine when nothing else is ready."""

    def wake(self) -> None:
        """End the current wait, so that the executor checks again whether an entity is ready."""

    def remove_node(self, node: Any) -> None:
        """Stop spinning a node."""

    def rcl_forget_work(self) -> None:
        """Drop the entities that were ready."""


class ClockProtocol(Protocol):
    """A source of time."""

    def now(self) -> Any:
        """Return the current time as a `rclpy.time.Time`."""


class NodeProtocol(Protocol):
    """The part of a node that its services and watchers use."""

    def get_name(self) -> str:
        """Return the node's name."""

    def get_fully_qualified_name(self) -> str:
        """Return the node's namespace and name."""

    def get_logger(self) -> Any:
        """Return the node's logger."""

    @property
    def create_service(self) -> Callable[..., Any]:
        """Create a service."""

    @property
    def create_publisher(self) -> Callable[..., Any]:
        """Create a publisher."""

    @property
    def create_subscription(self) -> Callable[..., Any]:
        """Create a subscription."""

    @property
    def destroy_subscription(self) -> Callable[..., bool]:
        """Destroy a subscription."""

    @property
    def has_parameter(self) -> Callable[..., bool]:
        """Return whether a parameter is declared."""

    @property
    def declare_parameter(self) -> Callable[..., Any]:
        """Declare a parameter."""

    @property
    def get_parameter(self) -> Callable[..., Any]:
        """Return a parameter by its name."""

    @property
    def add_on_set_parameters_callback(self) -> Callable[..., None]:
        """Register a function that accepts or rejects changes of parameters."""

    @property
    def describe_parameters(self) -> Callable[..., list[Any]]:
        """Return the descriptors of parameters."""

    @property
    def get_parameter_types(self) -> Callable[..., list[Any]]:
        """Return the types of parameters."""

    @property
    def list_parameters(self) -> Callable[..., Any]:
        """Return the names of parameters."""

    @property
    def set_parameters(self) -> Callable[..., list[Any]]:
        """Change parameters, one after the other."""

    @property
    def set_parameters_atomically(self) -> Callable[..., Any]:
        """Change all of the parameters, or none of them."""

    @property
    def remove_on_set_parameters_callback(self) -> Callable[..., None]:
        """Unregister a function that accepts or rejects changes of parameters."""

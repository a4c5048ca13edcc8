"""What stands for the C object behind a node, a publisher, a timer ..."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.facts import with_facts
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError

if TYPE_CHECKING:
    from rclpy.context import Context


class Handle:
    """An entity's `handle`. Inside `with entity.handle:` the entity is known to be there; as in ROS 2 `as` gives None.

    Everything else is asked of what is held.
    """

    def __init__(self, held: Any, is_destroyed: Callable[[], bool] = lambda: False) -> None:
        self._held = held
        self._is_destroyed = is_destroyed

    def __enter__(self) -> None:
        if self._is_destroyed():
            raise InvalidHandle('cannot use Destroyable because destruction was requested')

    def __exit__(self, *_: object) -> None:
        """Nothing to let go of."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._held, name)


def check_alive(endpoint: Any) -> None:
    """Raise InvalidHandle when an endpoint was destroyed."""
    if endpoint.destroyed:
        raise InvalidHandle('cannot use Destroyable because destruction was requested')


def check_endpoint(endpoint: Any, context: Context, what: str) -> None:
    """Raise what ROS 2 raises when something is asked of an endpoint that is gone, or after shutdown.

    :param what: how the error text begins, up to its colon, and whose context it is: 'failed to ...: publisher'.
    :raises InvalidHandle: the endpoint was destroyed.
    :raises RCLError: ROS 2 was shut down.
    """
    check_alive(endpoint)
    if not context.alive:
        raise with_facts(RCLError(f"{what}'s context is invalid"), 'programs.after-shutdown')

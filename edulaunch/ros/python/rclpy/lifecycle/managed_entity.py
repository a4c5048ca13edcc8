"""Objects that follow the lifecycle of their node."""

from __future__ import annotations

from functools import wraps
from typing import Any

from edulaunch.ros.read_only import ReadOnly
from rclpy.lifecycle.state_machine import LifecycleState, TransitionCallbackReturn


class ManagedEntity:
    """The base class of managed entities. Each transition of a node calls the corresponding method of the node's managed
    entities.
    """

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle the configuration of the node, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle the cleanup of the node, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle the shutdown of the node, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle the activation of the node, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle the deactivation of the node, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Handle a failed transition, and return the result of the callback."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """A managed entity that only records whether it is activated."""

    def __init__(self) -> None:
        self._enabled = False

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Enable the entity, and return SUCCESS."""
        self._enabled = True
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Disable the entity, and return SUCCESS."""
        self._enabled = False
        return TransitionCallbackReturn.SUCCESS

    is_activated: ReadOnly[bool] = ReadOnly('Whether it is enabled.', '_enabled')

    @staticmethod
    def when_enabled(wrapped: Any = None, *, when_not_enabled: Any = None) -> Any:
        """Return a decorator for methods that have an effect only while the entity is enabled.

        :param when_not_enabled: called in place of the method while the entity is disabled.
        """

        def decorator(method: Any) -> Any:
            @wraps(method)
            def only_when_enabled(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> None:
                if self._enabled:
                    method(self, *args, **kwargs)  # the return value is lost, as in rclpy
                elif when_not_enabled is not None:
                    when_not_enabled()

            return only_when_enabled

        return decorator if wrapped is None else decorator(wrapped)

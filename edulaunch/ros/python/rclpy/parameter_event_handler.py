"""A class that calls functions when parameters of any node change."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.qos import QoSProfile, qos_profile_parameter_events

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions


class ParameterCallbackHandle:
    """A callback for one parameter of one node. Store the handle: removing the callback requires it."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Any], None]) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """A callback for all parameter events. Store the handle: removing the callback requires it."""

    def __init__(self, callback: Callable[[Any], None]) -> None:
        self.callback = callback


class ParameterEventHandler:
    """A subscription to /parameter_events that calls functions for changed parameters.

    The handler checks parameters in the order in which their first callbacks were added. If a parameter has several callbacks,
    the newest callback is called first.
    """

    def __init__(
        self,
        node: Node,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> None:
        from rcl_interfaces.msg import ParameterEvent

        self.node = node
        self.qos_profile = qos_profile
        self._parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = {}
        self._event_callbacks: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            '/parameter_events',
            self._on_event,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self) -> None:
        """Destroy the subscription to /parameter_events."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    def _on_event(self, event: Any) -> None:
        for (parameter_name, node_name), handles in list(self._parameter_callbacks.items()):
            parameter = self.get_parameter_from_event(event, parameter_name, node_name)
            if parameter is not None:
                for handle in list(handles):
                    handle.callback(parameter)
        for event_handle in list(self._event_callbacks):
            event_handle.callback(event)

    @staticmethod
    def get_parameter_from_event(event: Any, parameter_name: str, node_name: str) -> Any:
        """Return the new or changed rcl_interfaces/Parameter with the given name in an event, or None if the event does not
        contain it.
        """
        if event.node != node_name:
            return None
        return next(
            (parameter for parameter in (*event.new_parameters, *event.changed_parameters) if parameter.name == parameter_name),
            None,
        )

    @staticmethod
    def get_parameters_from_event(event: Any) -> Iterator[Any]:
        """Yield all new and changed parameters of an event."""
        yield from event.new_parameters
        yield from event.changed_parameters

    def add_parameter_event_callback(self, callback: Callable[[Any], None]) -> ParameterEventCallbackHandle:
        """Call `callback(event)` for each event of any node."""
        handle = ParameterEventCallbackHandle(callback)
        self._event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Remove a callback that was added with `add_parameter_event_callback`. Raise RuntimeError if it was not added."""
        _remove(self._event_callbacks, handle)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Any], None]
    ) -> ParameterCallbackHandle:
        """Call `callback(parameter)` when the parameter of the node changes. A relative node name is resolved immediately."""
        handle = ParameterCallbackHandle(parameter_name, self._resolved(node_name), callback)
        self._parameter_callbacks.setdefault((parameter_name, handle.node_name), []).insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Remove a callback that was added with `add_parameter_callback`. Raise RuntimeError if it was not added."""
        key = handle.parameter_name, handle.node_name
        _remove(self._parameter_callbacks.get(key, []), handle)
        if not self._parameter_callbacks[key]:
            del self._parameter_callbacks[key]

    def _resolved(self, node_name: str) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        return self.node.resolve_topic_name(node_name, only_expand=True)


def _remove(handles: list[Any], handle: Any) -> None:
    if handle not in handles:
        raise RuntimeError("Callback doesn't exist")
    handles.remove(handle)


__getattr__ = passed_on(__name__)

"""A client that reads and changes the parameters of another node."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.client import while_looking
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file
from rclpy.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.subscription import Subscription

Done = Callable[[Future], None]


class AsyncParameterClient:
    """Calls the parameter services of a node. Each method returns the future of a service's response.

    :param remote_node_name: the name of the remote node, absolute or relative to this node's namespace.
    """

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        from rcl_interfaces import srv

        self.remote_node_name = remote_node_name
        self.node = node

        def client(srv_type: Any, name: str) -> Any:
            return node.create_client(
                srv_type, f'{remote_node_name}/{name}', qos_profile=qos_profile, callback_group=callback_group
            )

        self._get = client(srv.GetParameters, 'get_parameters')
        self._list = client(srv.ListParameters, 'list_parameters')
        self._set = client(srv.SetParameters, 'set_parameters')
        self._get_types = client(srv.GetParameterTypes, 'get_parameter_types')
        self._describe = client(srv.DescribeParameters, 'describe_parameters')
        self._set_atomically = client(srv.SetParametersAtomically, 'set_parameters_atomically')

    @property
    def _clients(self) -> tuple[Any, ...]:
        return self._list, self._set, self._get, self._get_types, self._describe, self._set_atomically

    def services_are_ready(self) -> bool:
        """Return whether all six services exist."""
        return all(client.service_is_ready() for client in self._clients)

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Check every 0.25 s whether all services exist. Return whether they exist before the timeout."""
        while_looking(self.node.context, self.services_are_ready, timeout_sec)
        return self.services_are_ready()

    @staticmethod
    def _call(client: Any, callback: Done | None, **fields: Any) -> Future:
        future: Future = client.call_async(client.srv_type.Request(**fields))
        if callback is not None:
            future.add_done_callback(callback)
        return future

    def list_parameters(
        self, prefixes: list[str] | None = None, depth: int | None = None, callback: Done | None = None
    ) -> Future:
        """Request the names of the parameters under `prefixes`."""
        return self._call(self._list, callback, prefixes=prefixes or [], depth=depth or 0)

    def get_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Request the values of parameters."""
        return self._call(self._get, callback, names=names)

    def set_parameters(self, parameters: Sequence[Any], callback: Done | None = None) -> Future:
        """Set each parameter separately. The items are Parameters or rcl_interfaces/Parameter messages."""
        return self._call(self._set, callback, parameters=_messages(parameters))

    def describe_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Request the descriptors of parameters."""
        return self._call(self._describe, callback, names=names)

    def get_parameter_types(self, names: list[str], callback: Done | None = None) -> Future:
        """Request the types of parameters."""
        return self._call(self._get_types, callback, names=names)

    def set_parameters_atomically(self, parameters: Sequence[Any], callback: Done | None = None) -> Future:
        """Set all of the parameters, or none of them."""
        return self._call(self._set_atomically, callback, parameters=_messages(parameters))

    def delete_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Delete parameters, if the remote node allows it."""
        return self.set_parameters([Parameter(name) for name in names], callback)

    def on_parameter_event(
        self,
        callback: Callable[[Any], object],
        qos_profile: QoSProfile = qos_profile_parameter_events,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Call `callback(event)` for each rcl_interfaces/ParameterEvent of any node. Return the subscription."""
        from rcl_interfaces.msg import ParameterEvent

        return self.node.create_subscription(
            ParameterEvent,
            '/parameter_events',
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def load_parameter_file(self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None) -> Future:
        """Set all parameters of a file on the remote node. The names of the nodes in the file are ignored.

        :param use_wildcard: whether to include entries under `/**`.
        """
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters(list(found.values()), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None
    ) -> Future:
        """Set all parameters of a file, or none of them; see :meth:`load_parameter_file`."""
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters_atomically(list(found.values()), callback)


def _messages(parameters: Sequence[Any]) -> list[Any]:
    return [parameter.to_parameter_msg() if isinstance(parameter, Parameter) else parameter for parameter in parameters]


__getattr__ = passed_on(__name__)

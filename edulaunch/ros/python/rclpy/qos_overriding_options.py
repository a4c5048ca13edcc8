"""Options that make parameters override the quality of service of an endpoint."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.qos import QoSPolicyEnum, QoSProfile
from rclpy.qos_compatibility import QoSPolicyKind

if TYPE_CHECKING:
    from rcl_interfaces.msg import SetParametersResult


QosCallbackType = Callable[[QoSProfile], 'SetParametersResult']


class InvalidQosOverridesError(Exception):
    """The callback of the options rejected the profile."""


class QoSOverridingOptions:
    """The policies that parameters may override.

    :param policy_kinds: the policies that may be overridden.
    :param callback: called with the resulting profile, which it may reject.
    :param entity_id: distinguishes several endpoints of one topic in one node.
    """

    def __init__(
        self, policy_kinds: Iterable[QoSPolicyKind], *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> None:
        self._policy_kinds = policy_kinds
        self._callback = callback
        self._entity_id = entity_id

    policy_kinds: ReadOnly[Iterable[QoSPolicyKind]] = ReadOnly('The policies.', '_policy_kinds')

    callback: ReadOnly[QosCallbackType | None] = ReadOnly('The callback that may refuse.', '_callback')

    entity_id: ReadOnly[str | None] = ReadOnly("The endpoint's own id.", '_entity_id')

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        """Return options for history, depth and reliability."""
        return cls(
            (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY), callback=callback, entity_id=entity_id
        )


def declare_qos_parameters(node: Any, side: str, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions) -> QoSProfile:
    """Declare the read-only parameters `qos_overrides.<topic>.<side>[_<id>].<policy>`. Return the profile with their values.

    :param side: 'publisher' or 'subscription'.
    :raises InvalidQosOverridesError: when the callback of the options rejects the profile.
    :raises RuntimeError: when a parameter has a value that its policy does not support.
    """
    from rcl_interfaces.msg import ParameterDescriptor

    suffix = f'_{options.entity_id}' if options.entity_id else ''
    endpoint = f'{side} `{topic_name}` with id `{options.entity_id}`'
    profile = QoSProfile(**{slot[1:]: getattr(qos, slot) for slot in QoSProfile.__slots__})
    for kind in options.policy_kinds:
        if side == 'subscription' and kind is QoSPolicyKind.LIFESPAN:
            continue  # only publishers have this policy in DDS
        policy = kind.name.lower()
        name = f'qos_overrides.{topic_name}.{side}{suffix}.{policy}'
        descriptor = ParameterDescriptor(description=f'{policy} for {endpoint}', read_only=True)
        if node.has_parameter(name):
            parameter = node.get_parameter(name)
        else:
            parameter = node.declare_parameter(name, _to_parameter(getattr(profile, policy)), descriptor)
        setattr(profile, policy, _to_policy(policy, getattr(profile, policy), parameter))
    if options.callback is not None:
        result = options.callback(profile)
        if not result.successful:
            raise InvalidQosOverridesError(f'Provided QoS overrides for {endpoint}, are not valid: {result.reason}')
    return profile


def _to_parameter(value: Any) -> Any:
    if isinstance(value, QoSPolicyEnum):
        return value.short_key
    return value.nanoseconds if isinstance(value, Duration) else value


def _to_policy(policy: str, present: Any, parameter: Parameter) -> Any:
    if isinstance(present, QoSPolicyEnum):
        if parameter.value.upper() not in type(present).__members__:
            raise with_facts(
                RuntimeError(f'Unexpected QoS override for policy `{policy}`: `{parameter.value}`'),
                'messages.qos-override',
                policy=str(policy),
                value=str(parameter.value),
                allowed=list(type(present).short_keys()),
            )
        return type(present).get_from_short_key(parameter.value)
    return Duration(nanoseconds=parameter.value) if isinstance(present, Duration) else parameter.value


__getattr__ = passed_on(__name__)

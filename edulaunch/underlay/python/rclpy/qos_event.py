"""The older name of `rclpy.event_handler`."""
from __future__ import annotations

from rclpy.event_handler import (
    EventHandler,
    MatchedInfo,
    PublisherEventCallbacks,
    QoSEventHandler,
    QoSOfferedIncompatibleQoSInfo,
    QoSPublisherEventType,
    QoSRequestedIncompatibleQoSInfo,
    QoSSubscriptionEventType,
    SubscriptionEventCallbacks,
)
from rclpy.impl.passed_on import passed_on

__all__ = [
    'EventHandler', 'MatchedInfo', 'PublisherEventCallbacks', 'QoSEventHandler', 'QoSOfferedIncompatibleQoSInfo',
    'QoSPublisherEventType', 'QoSRequestedIncompatibleQoSInfo', 'QoSSubscriptionEventType', 'SubscriptionEventCallbacks',
]


__getattr__ = passed_on(__name__, {
    'typing': 'Callable List Optional', 'rclpy.callback_groups': 'CallbackGroup', 'enum': 'IntEnum',
    'rclpy.waitable': 'NumberOfEntities Waitable', 'rclpy._rclpy_pybind11': 'UnsupportedEventTypeError',
    'rclpy.logging': 'get_logger', 'rclpy.qos': 'qos_policy_name_from_kind',
})

"""The older name of `rclpy.event_handler`; ROS 2 warns of it, once in each process, and modules are shared by processes here."""

from __future__ import annotations

from rclpy.impl.passed_on import passed_on

__getattr__ = passed_on(
    __name__,
    {
        'rclpy.event_handler': 'EventHandler IncompatibleTypeInfo MatchedInfo PublisherEventCallbacks QoSEventHandler '
        'QoSLivelinessChangedInfo QoSLivelinessLostInfo QoSMessageLostInfo QoSOfferedDeadlineMissedInfo '
        'QoSOfferedIncompatibleQoSInfo QoSPublisherEventType QoSPublisherMatchedInfo QoSRequestedDeadlineMissedInfo '
        'QoSRequestedIncompatibleQoSInfo QoSSubscriptionEventType QoSSubscriptionMatchedInfo SubscriptionEventCallbacks',
        'typing': 'Callable List Optional',
        'rclpy.callback_groups': 'CallbackGroup',
        'enum': 'IntEnum',
        'rclpy.waitable': 'NumberOfEntities Waitable',
        'rclpy._rclpy_pybind11': 'UnsupportedEventTypeError',
        'rclpy.logging': 'get_logger',
        'rclpy.qos': 'qos_policy_name_from_kind',
    },
)

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

__all__ = [
    'EventHandler', 'MatchedInfo', 'PublisherEventCallbacks', 'QoSEventHandler', 'QoSOfferedIncompatibleQoSInfo',
    'QoSPublisherEventType', 'QoSRequestedIncompatibleQoSInfo', 'QoSSubscriptionEventType', 'SubscriptionEventCallbacks',
]

"""Filters through which messages pass before a program receives them: a cache, synchronizers, and a filter that waits for tf.

In ROS 2, the filter that waits for tf exists only in C++, as `tf2_ros::MessageFilter`.
"""

from __future__ import annotations

from message_filters.filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from message_filters.tf2_message_filter import FilterFailureReason, MessageFilter

__all__ = [
    'ApproximateTimeSynchronizer',
    'Cache',
    'FilterFailureReason',
    'MessageFilter',
    'SimpleFilter',
    'Subscriber',
    'TimeSynchronizer',
]

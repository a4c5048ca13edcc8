"""Filters that messages pass through before a program sees them: by time, in pairs, or when tf knows their frame."""

from __future__ import annotations

from message_filters.approximate_time_synchronizer import ApproximateTimeSynchronizer
from message_filters.cache import Cache
from message_filters.simple_filter import SimpleFilter
from message_filters.subscriber import Subscriber
from message_filters.tf2_message_filter import FilterFailureReason, MessageFilter
from message_filters.time_synchronizer import TimeSynchronizer

__all__ = [
    'ApproximateTimeSynchronizer',
    'Cache',
    'FilterFailureReason',
    'MessageFilter',
    'SimpleFilter',
    'Subscriber',
    'TimeSynchronizer',
]

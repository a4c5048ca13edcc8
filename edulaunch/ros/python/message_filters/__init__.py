"""Filters that messages pass through before a program sees them: by time, in pairs, or when tf knows their frame."""

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

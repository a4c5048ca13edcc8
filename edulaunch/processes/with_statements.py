"""What is known about a `with` around something of ROS that is no context manager."""

from __future__ import annotations

import linecache
import re
from types import TracebackType
from typing import Any

ENDINGS = {
    'Node': 'destroy_node()',
    'LifecycleNode': 'destroy_node()',
    'Publisher': 'destroy()',
    'LifecyclePublisher': 'destroy()',
    'Subscription': 'destroy()',
    'Client': 'destroy()',
    'Service': 'destroy()',
    'Timer': 'destroy()',
    'GuardCondition': 'destroy()',
    'Rate': 'destroy()',
}
"""What ends something that rclpy makes, by its class."""


def with_facts_at(error: BaseException) -> dict[str, Any]:
    """For `with rclpy.init():`, and for `with node:` where Python tells the class of what it was given (since 3.11)."""
    if '__enter__' not in str(error) and 'context manager' not in str(error):
        return {}
    trace = _innermost(error.__traceback__)
    if trace is None:
        return {}
    if 'rclpy.init(' in linecache.getline(trace.tb_frame.f_code.co_filename, trace.tb_lineno):
        return {'about': 'programs.with-init'}
    said = re.match(r"'(?:[\w.]+\.)?(\w+)' object does not support the \w*? ?context manager protocol", str(error))
    ending = None if said is None else ENDINGS.get(_kind(said[1], trace))
    return {} if said is None or ending is None else {'about': 'programs.with-entity', 'thing': said[1], 'ending': ending}


def _innermost(trace: TracebackType | None) -> TracebackType | None:
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace


def _kind(name: str, trace: TracebackType) -> str:
    """The class of rclpy behind the name of a class: its nearest base there, or the name when the program does not have it."""
    known = trace.tb_frame.f_locals.get(name) or trace.tb_frame.f_globals.get(name)
    if not isinstance(known, type):
        return name
    return next((base.__name__ for base in known.__mro__ if base.__module__.startswith('rclpy.')), '')

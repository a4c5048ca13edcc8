"""The line of help for `with` around something of ROS that is no context manager."""

from __future__ import annotations

import linecache
import re
from types import TracebackType

INIT = 'in ROS 2 Jazzy rclpy.init() gives nothing for `with`, as it does in later versions: call it on a line of its own'

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


def with_help(error: BaseException) -> str | None:
    """For `with rclpy.init():`, and for `with node:` where Python tells the class of what it was given (since 3.11)."""
    if '__enter__' not in str(error) and 'context manager' not in str(error):
        return None
    trace = _innermost(error.__traceback__)
    if trace is None:
        return None
    if 'rclpy.init(' in linecache.getline(trace.tb_frame.f_code.co_filename, trace.tb_lineno):
        return INIT
    said = re.match(r"'(?:[\w.]+\.)?(\w+)' object does not support the \w*? ?context manager protocol", str(error))
    ending = None if said is None else ENDINGS.get(_kind(said[1], trace))
    return (
        None
        if said is None or ending is None
        else (f'in ROS 2 a {said[1]} is not for `with`: make it on a line of its own and call its {ending} at the end')
    )


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

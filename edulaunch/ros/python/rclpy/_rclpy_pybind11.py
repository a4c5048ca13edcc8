"""The errors of ROS 2's C layer, under the names that tracebacks show."""

from __future__ import annotations


class RCLError(RuntimeError):
    """A failure that the C layer reports."""


class RCLInvalidROSArgsError(RCLError):
    """The arguments after `--ros-args` are invalid."""


class UnknownROSArgsError(RuntimeError):
    """There are unknown arguments after `--ros-args`. The message is a Python list of these arguments."""


class RMWError(RuntimeError):
    """A failure that the middleware reports."""


class InvalidHandle(RuntimeError):
    """A program used a destroyed object."""


class NodeNameNonExistentError(RCLError):
    """A graph query names a node that does not exist."""


class UnsupportedEventTypeError(RCLError):
    """The middleware does not support the event of an event callback."""


class NotImplementedByRMWError(Exception):
    """The middleware does not support the called function."""


class TimerCancelledError(RCLError):
    """A program requested the time of the next call of a cancelled timer."""

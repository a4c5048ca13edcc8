"""The errors that ROS 2's C layer raises, under the name by which tracebacks show them."""

from __future__ import annotations


class RCLError(RuntimeError):
    """Any failure reported by the C layer."""


class RCLInvalidROSArgsError(RCLError):
    """The arguments after `--ros-args` cannot be understood."""


class UnknownROSArgsError(RuntimeError):
    """There are arguments after `--ros-args` that mean nothing; the text is the Python list of them."""


class RMWError(RuntimeError):
    """Any failure reported by the middleware."""


class InvalidHandle(RuntimeError):
    """Something was used after it was destroyed."""


class NodeNameNonExistentError(RCLError):
    """A graph query names a node that does not exist."""


class UnsupportedEventTypeError(RCLError):
    """An event callback is for an event that the middleware does not have."""


class NotImplementedByRMWError(Exception):
    """The middleware cannot do this."""


class TimerCancelledError(RCLError):
    """A timer that was cancelled was asked when it fires."""

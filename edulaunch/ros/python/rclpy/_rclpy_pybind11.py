"""The errors of ROS 2's C layer, under their names in tracebacks."""

from __future__ import annotations


class RCLError(RuntimeError):
    """Any failure reported by the C layer."""


class RCLInvalidROSArgsError(RCLError):
    """The arguments after `--ros-args` are invalid."""


class UnknownROSArgsError(RuntimeError):
    """There are unknown arguments after `--ros-args`. The message is the Python list of them."""


class RMWError(RuntimeError):
    """Any failure reported by the middleware."""


class InvalidHandle(RuntimeError):
    """A destroyed object was used."""


class NodeNameNonExistentError(RCLError):
    """A graph query names a node that does not exist."""


class UnsupportedEventTypeError(RCLError):
    """The middleware does not have the event of an event callback."""


class NotImplementedByRMWError(Exception):
    """The middleware does not support this."""


class TimerCancelledError(RCLError):
    """A program asked a cancelled timer for its next call."""

"""tf2's exceptions. They print with the module name `tf2`, as the real library's do."""

from __future__ import annotations

from edulaunch.tf import TransformFailure


class TransformException(Exception):
    """Base of all tf2 exceptions: no transform could be given."""

    __module__ = 'tf2'


class LookupException(TransformException):
    """A frame does not exist, or the tree runs in a loop."""

    __module__ = 'tf2'


class ConnectivityException(TransformException):
    """Both frames exist, but are not in the same tree."""

    __module__ = 'tf2'


class ExtrapolationException(TransformException):
    """There is no data at the requested time."""

    __module__ = 'tf2'


class InvalidArgumentException(TransformException):
    """A frame name is empty or starts with a slash."""

    __module__ = 'tf2'


class TimeoutException(TransformException):
    """An answer did not come in time (buffer client only)."""

    __module__ = 'tf2'


_BY_KIND: dict[str, type[TransformException]] = {
    'lookup': LookupException,
    'connectivity': ConnectivityException,
    'extrapolation': ExtrapolationException,
    'invalid_argument': InvalidArgumentException,
}


def exception_of(failure: TransformFailure) -> TransformException:
    """The tf2 exception that belongs to a failure of `edulaunch.tf`."""
    return _BY_KIND[failure.kind](str(failure))

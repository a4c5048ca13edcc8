"""The error that the buffer raises for a lookup without a result."""

from __future__ import annotations

LOOKUP = 'lookup'
CONNECTIVITY = 'connectivity'
EXTRAPOLATION = 'extrapolation'
INVALID_ARGUMENT = 'invalid_argument'


class TransformFailure(Exception):
    """A lookup has no result. The message is that of the real tf2.

    Students do not see this error, because `tf2_py` raises the exception of tf2 that belongs to `kind`.

    :param kind: one of the kinds that this module defines.
    :param text: the message.
    """

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = kind

"""The error of the buffer for a lookup without a result."""

from __future__ import annotations

LOOKUP = 'lookup'
CONNECTIVITY = 'connectivity'
EXTRAPOLATION = 'extrapolation'
INVALID_ARGUMENT = 'invalid_argument'


class TransformFailure(Exception):
    """A lookup without a result; `str()` is the message of the real tf2. It never reaches a student, because `tf2_py` raises
    the exception of tf2 that belongs to `kind`.

    :param kind: one of the kinds of this module.
    """

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = kind

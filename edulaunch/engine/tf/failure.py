"""What the buffer raises when it has no answer."""

from __future__ import annotations

LOOKUP = 'lookup'
CONNECTIVITY = 'connectivity'
EXTRAPOLATION = 'extrapolation'
INVALID_ARGUMENT = 'invalid_argument'


class TransformFailure(Exception):
    """A lookup that has no answer; `str()` is real tf2's text.

    It never reaches a student: the face `tf2_py` raises the tf2 exception that belongs to `kind`.

    :param kind: one of the words of this module.
    """

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = kind

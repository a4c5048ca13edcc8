"""Single precision, as the fields of a turtlesim message have it."""
from __future__ import annotations

from struct import Struct

_single = Struct('f')
_pack = _single.pack
_unpack = _single.unpack


def as_float32(value: float) -> float:
    """Round `value` to the nearest 32-bit float, as storing it in a C `float` does.

    :raises OverflowError: when the value is finite but too large for 32 bits.
    """
    rounded: float = _unpack(_pack(value))[0]
    return rounded

"""Single precision, as the fields of a turtlesim message have it."""

from __future__ import annotations

from math import copysign, inf
from struct import Struct

_single = Struct('f')
_pack = _single.pack
_unpack = _single.unpack


def as_float32(value: float) -> float:
    """Round `value` to the nearest 32-bit float, as a C `float` does; one too large becomes infinite."""
    try:
        rounded: float = _unpack(_pack(value))[0]
    except OverflowError:
        return copysign(inf, value)
    return rounded

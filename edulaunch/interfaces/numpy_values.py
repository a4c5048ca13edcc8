"""What Jazzy takes for a sequence of numbers beside a list of just the right numbers."""

from __future__ import annotations

import sys
from array import array
from typing import Any

from edulaunch.interfaces.kinds import Kind


def python_values(values: Any, kind: Kind) -> Any:
    """What Jazzy makes of them: an `array.array` or numpy array of the field's kind takes integers for floats, numpy's numbers
    for Python's, and goes through any iterable.

    :param kind: of the field's elements.
    :return: an array for a numpy array of just that kind (an image), else a list of Python's numbers; `values` itself where
        Jazzy refuses, too: an array with rows, floats where integers are wanted, text.
    """
    numpy = sys.modules.get('numpy')
    numbers: tuple[type, ...] = (int, float) if kind.python is float else (int,)
    if numpy is not None:
        numbers += (numpy.integer, numpy.floating) if kind.python is float else (numpy.integer,)
        if isinstance(values, numpy.ndarray):
            if values.ndim != 1 or not issubclass(values.dtype.type, numbers):
                return values
            return array(kind.code, values.tobytes()) if values.dtype == kind.name else list(map(kind.python, values.tolist()))
    if isinstance(values, (str, bytes, bytearray, memoryview)):
        return values
    try:
        return [kind.python(value) if isinstance(value, numbers) else value for value in values]
    except (TypeError, OverflowError):  # no iterable; an integer that no float can hold
        return values

"""The message about an argument of a wrong type."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def ensure_argument_type(argument: Any, types: type | Iterable[type], argument_name: str, caller: str | None = None) -> None:
    """Check that `argument` is an instance of one of `types`.

    :param caller: the function or class named in the message.
    :raises TypeError: naming the caller, the argument, the expected types, and what came.
    """
    expected = types if isinstance(types, tuple) else (types,) if isinstance(types, type) else tuple(types)
    if isinstance(argument, expected):
        return
    start = 'Expected' if caller is None else f"'{caller}' expected"
    shown = ', '.join(str(one) for one in expected)
    raise TypeError(f"{start} '{argument_name}' to be one of [{shown}], but got '{argument}' of type '{type(argument)}'")

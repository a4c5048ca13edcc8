"""The decorator that repeats a launch and its tests for several values."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from typing import Any

Description = Callable[..., Any]


Parametrized = Callable[[], Iterator[tuple[Description, dict[str, Any]]]]


def parametrize(argnames: str | Iterable[str], argvalues: Iterable[Any]) -> Callable[[Description], Parametrized]:
    """Launch and test once for each item of `argvalues`.

    The values are passed to `generate_test_description` and, by the same names, to the test methods.

    :param argnames: one name, several names separated by commas, or a list of names.
    :param argvalues: a value for each launch, or a tuple of values if there are several names.
    :raises ValueError: when the number of values is not the number of names.
    """
    names = [name.strip() for name in argnames.split(',') if name.strip()] if isinstance(argnames, str) else list(argnames)
    rows = [_row(names, value) for value in argvalues]

    def decorate(function: Description) -> Parametrized:
        @functools.wraps(function)
        def each() -> Iterator[tuple[Description, dict[str, Any]]]:
            for row in rows:
                yield functools.partial(function, **row), row

        each.__parametrized__ = True  # type: ignore[attr-defined]
        return each

    return decorate


def _row(names: list[str], value: Any) -> dict[str, Any]:
    plain = len(names) == 1 and not (isinstance(value, (list, tuple)) and len(value) == 1)
    values = [value] if plain else list(value)
    if len(values) != len(names):
        raise ValueError(f'parametrize: {len(names)} names {names}, but {len(values)} values {values}')
    return dict(zip(names, values, strict=True))

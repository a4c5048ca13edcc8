"""Base classes of launch's classes."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

from edulaunch.ros.read_only import ReadOnly as ReadOnly


class StableRepr:
    """Python's default `repr` with `0x` in place of the address.

    Some error messages of launch contain the `repr` of substitutions and actions. With an address, two equal runs would print
    different messages.
    """

    def __repr__(self) -> str:
        cls = type(self)
        return f'<{cls.__module__}.{cls.__qualname__} object at 0x>'


Parse = Callable[..., tuple[type, dict[str, Any]]]


class ParsedByFrontend:
    """A descriptor for the method `parse`. It returns the class on which `parse` was called, and the arguments for the nearest
    class that the frontend has a parser for.

    So `super().parse(entity, parser)` in a student's subclass returns the keyword arguments of the base class.

    :param kind: 'action' or 'substitution'.
    :param otherwise: the function for classes that the frontend has no parser for. Without this function, these classes have
        no `parse`.
    """

    def __init__(self, kind: str, otherwise: Parse | None = None) -> None:
        self._kind = kind
        self._otherwise = otherwise

    def __get__(self, instance: object, owner: type | None = None) -> Parse:
        made = owner if owner is not None else type(instance)
        methods: dict[str, Any] = getattr(import_module(f'{__package__}.frontend.expose'), f'{self._kind}_parse_methods')
        makers = {(getattr(one, 'module', ''), getattr(one, 'class_name', '')): one for one in methods.values()}
        read = next((makers[key] for key in ((base.__module__, base.__name__) for base in made.__mro__) if key in makers), None)
        parse = read or self._otherwise
        if parse is None:
            raise AttributeError(f"type object {made.__name__!r} has no attribute 'parse'")
        found: Parse = parse

        def parse_as(*args: Any) -> tuple[type, dict[str, Any]]:
            return made, found(*args)[1]

        return parse_as

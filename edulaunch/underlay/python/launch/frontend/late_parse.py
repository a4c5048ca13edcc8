"""Parse functions that are imported when first called, so that a launch file pays only for what it uses."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

Parsed = tuple[type, dict[str, Any]]
"""What to make: a class (or function) and its keyword arguments."""
ParseMethod = Callable[..., Parsed]


class LateParse:
    """The parse function `name` of `module`."""

    __slots__ = ('module', 'name', '_parse')

    def __init__(self, module: str, name: str) -> None:
        self.module = module
        self.name = name
        self._parse: ParseMethod | None = None

    def __call__(self, *args: Any, **kwargs: Any) -> Parsed:
        parse = self._parse
        if parse is None:
            parse = self._parse = getattr(import_module(self.module), self.name)
        return parse(*args, **kwargs)


class LateSubstitution:
    """Parses `$(name ...)` for a class that is imported when first needed.

    :param keywords: from the arguments of the `$(...)` to the keyword arguments of the class.
    """

    __slots__ = ('module', 'class_name', 'keywords', '_class')

    def __init__(self, module: str, class_name: str, keywords: Callable[[list[Any]], dict[str, Any]]) -> None:
        self.module = module
        self.class_name = class_name
        self.keywords = keywords
        self._class: type | None = None

    def __call__(self, arguments: list[Any]) -> Parsed:
        kwargs = self.keywords(arguments)
        if self._class is None:
            self._class = getattr(import_module(self.module), self.class_name)
        return self._class, kwargs

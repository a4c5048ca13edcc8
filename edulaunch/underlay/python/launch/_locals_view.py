"""The locals of a launch context."""

from __future__ import annotations

from typing import Any, NoReturn


class LocalsView:
    """Reads a dictionary through attributes.

    :raises AttributeError: for a name that is not in it, listing those that are; and on every attempt to set
        one.
    """

    def __init__(self, values: dict[str, Any]) -> None:
        object.__setattr__(self, '_values', values)

    def __getattr__(self, name: str) -> Any:
        values: dict[str, Any] = object.__getattribute__(self, '_values')
        if name not in values:
            raise AttributeError(f"context.locals does not contain attribute '{name}', it contains: [{', '.join(values)}]")
        return values[name]

    def __setattr__(self, name: str, value: Any) -> NoReturn:
        raise AttributeError("can't set attribute, locals are read-only")

"""Something to await that is over already."""

from __future__ import annotations

from collections.abc import Coroutine, Generator
from typing import Any


class Done(Coroutine[Any, Any, None]):
    """A coroutine with nothing left to do. Unlike one of an `async def` it may also be thrown away without a warning."""

    def send(self, value: Any) -> Any:
        """Ends at once."""
        raise StopIteration

    def throw(self, typ: Any, val: Any = None, tb: Any = None) -> Any:
        """Ends with that exception."""
        raise typ if val is None else val

    def close(self) -> None:
        """Nothing is left to close."""

    def __await__(self) -> Generator[Any, None, None]:
        return
        yield

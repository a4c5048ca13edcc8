"""The output of a program as lines."""

from __future__ import annotations

from collections.abc import Callable


class OutputLines:
    """Cuts text that comes in pieces into lines; a line is passed on when it is complete.

    :param emit: called with each line, without its end.
    :param cached: keep everything, for :attr:`text`.
    """

    def __init__(self, emit: Callable[[str], object], cached: bool) -> None:
        self._emit = emit
        self._rest = ''
        self._pieces: list[str] | None = [] if cached else None

    @property
    def text(self) -> str:
        """Everything that came so far."""
        return ''.join(self._pieces or ())

    def write(self, data: bytes) -> None:
        """Take the next piece. Bytes that are not UTF-8 are replaced."""
        text = data.decode('utf-8', errors='replace')
        if self._pieces is not None:
            self._pieces.append(text)
        lines = (self._rest + text).split('\n')
        self._rest = lines.pop()
        for line in lines:
            self._emit(line)

    def flush(self) -> None:
        """Pass on what is left of a line that was never completed."""
        rest, self._rest = self._rest, ''
        if rest:
            self._emit(rest)

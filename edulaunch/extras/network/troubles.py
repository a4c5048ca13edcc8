"""What went wrong on the way over a network: each told once, and counted."""

from __future__ import annotations

from collections.abc import Callable

from edulaunch.extras.network.link import Trouble

MOST = 100
MOST_NAMED = 3
"""Of troubles that differ in a name alone a line says so many names."""


class Troubles:
    """Keeps what went wrong.

    :param tell: called with each text, the first time.
    :param note: called with its key, the first time: for the record, of which advice is made.
    """

    def __init__(self, tell: Callable[[str], object], note: Callable[[str], object] = lambda key: None) -> None:
        self._tell, self._note = tell, note
        self._counts: dict[str, tuple[Trouble, int]] = {}

    def add(self, trouble: Trouble) -> None:
        """It has happened (again)."""
        first, count = self._counts.get(trouble.key, (trouble, 0))
        if count or len(self._counts) < MOST:
            self._counts[trouble.key] = first, count + 1
        if not count and len(self._counts) < MOST:
            self._tell(trouble.text)
            self._note(trouble.key)

    def lines(self) -> list[str]:
        """All of them, for `edulaunch network status`; those that differ in a name alone are one."""
        groups: dict[str, list[tuple[Trouble, int]]] = {}
        for trouble, count in self._counts.values():
            shape = trouble.text.replace(trouble.about, '\0') if trouble.about else trouble.text
            groups.setdefault(shape, []).append((trouble, count))
        return [_line(shape, rows) for shape, rows in groups.items()]


def _line(shape: str, rows: list[tuple[Trouble, int]]) -> str:
    names = [trouble.about for trouble, _ in rows]
    more = f' and {len(names) - MOST_NAMED} more' if len(names) > MOST_NAMED else ''
    count = sum(count for _, count in rows)
    times = f' ({count} times)' if count > len(rows) else ''
    return shape.replace('\0', ', '.join(names[:MOST_NAMED]) + more) + times

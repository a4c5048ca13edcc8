"""What went wrong on the way over a network: each told once, and counted."""

from __future__ import annotations

from collections.abc import Callable

from edulaunch.extras.network.link import LinkDiagnostic

MOST = 100
MOST_NAMED = 3
"""Of diagnostics that differ in a name alone a line says so many names."""


class LinkDiagnostics:
    """Keeps what went wrong.

    :param tell: called with each text, the first time.
    :param note: called with its key, the first time: for the record, of which advice is made.
    """

    def __init__(self, tell: Callable[[str], object], note: Callable[[str], object] = lambda key: None) -> None:
        self._tell, self._note = tell, note
        self._counts: dict[str, tuple[LinkDiagnostic, int]] = {}

    def add(self, diagnostic: LinkDiagnostic) -> None:
        """It has happened (again)."""
        first, count = self._counts.get(diagnostic.key, (diagnostic, 0))
        if count or len(self._counts) < MOST:
            self._counts[diagnostic.key] = first, count + 1
        if not count and len(self._counts) < MOST:
            self._tell(diagnostic.text)
            self._note(diagnostic.key)

    def lines(self) -> list[str]:
        """All of them, for `edulaunch network status`; those that differ in a name alone are one."""
        groups: dict[str, list[tuple[LinkDiagnostic, int]]] = {}
        for diagnostic, count in self._counts.values():
            shape = diagnostic.text.replace(diagnostic.about, '\0') if diagnostic.about else diagnostic.text
            groups.setdefault(shape, []).append((diagnostic, count))
        return [_line(shape, rows) for shape, rows in groups.items()]


def _line(shape: str, rows: list[tuple[LinkDiagnostic, int]]) -> str:
    names = [diagnostic.about for diagnostic, _ in rows]
    more = f' and {len(names) - MOST_NAMED} more' if len(names) > MOST_NAMED else ''
    count = sum(count for _, count in rows)
    times = f' ({count} times)' if count > len(rows) else ''
    return shape.replace('\0', ', '.join(names[:MOST_NAMED]) + more) + times

"""Problems of a network link. Each problem is reported once, and counted."""

from __future__ import annotations

from collections.abc import Callable

from edulaunch.extras.network.network_link import LinkDiagnostic

MOST = 100
MOST_NAMED = 3
"""The maximum number of names in one line, for diagnostics that differ only in a name."""


class LinkDiagnostics:
    """Stores the problems of a link.

    :param tell: called with the message of a problem when the problem first occurs.
    :param note: called with the key of a problem when the problem first occurs. It adds the problem to the recording, which
        edulaunch uses for advice.
    """

    def __init__(self, tell: Callable[[str], object], note: Callable[[str], object] = lambda key: None) -> None:
        self._tell, self._note = tell, note
        self._counts: dict[str, tuple[LinkDiagnostic, int]] = {}

    def add(self, diagnostic: LinkDiagnostic) -> None:
        """Count an occurrence of a problem."""
        first, count = self._counts.get(diagnostic.key, (diagnostic, 0))
        if count or len(self._counts) < MOST:
            self._counts[diagnostic.key] = first, count + 1
        if not count and len(self._counts) < MOST:
            self._tell(diagnostic.text)
            self._note(diagnostic.key)

    def lines(self) -> list[str]:
        """Return all messages for `edulaunch network status`. Messages that differ only in a name become one line."""
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

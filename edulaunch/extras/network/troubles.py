"""What went wrong on the way over a network: each told once, and counted."""

from __future__ import annotations

from collections.abc import Callable

from edulaunch.extras.network.link import Trouble

MOST = 100


class Troubles:
    """Keeps what went wrong.

    :param tell: called with each text, the first time.
    :param note: called with its key, the first time: for the record, of which advice is made.
    """

    def __init__(self, tell: Callable[[str], object], note: Callable[[str], object] = lambda key: None) -> None:
        self._tell, self._note = tell, note
        self.counts: dict[str, tuple[str, int]] = {}

    def add(self, trouble: Trouble) -> None:
        """It has happened (again)."""
        text, count = self.counts.get(trouble.key, (trouble.text, 0))
        if count or len(self.counts) < MOST:
            self.counts[trouble.key] = text, count + 1
        if not count and len(self.counts) < MOST:
            self._tell(text)
            self._note(trouble.key)

    def lines(self) -> list[str]:
        """All of them, for `edulaunch network status`."""
        return [f'{text}' + (f' ({count} times)' if count > 1 else '') for text, count in self.counts.values()]

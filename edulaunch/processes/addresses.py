"""Addresses of objects in what a program writes: `<rclpy.task.Future object at 0x7f0000000010>`.

Beginners print futures, nodes and methods. The real addresses differ from run to run, and recordings must not; so they are shown
numbered, in the order of their appearance.
"""

from __future__ import annotations

import re

FIRST = 0x7F0000000010
MARK = ' at 0x'
"""What to look for before anything else is done with a text."""
_ADDRESS = re.compile(r'(?<= at )0x[0-9a-f]{5,16}\b')


class Addresses:
    """What one program has written of addresses so far."""

    def __init__(self) -> None:
        self._shown: dict[str, str] = {}
        self._count = 0

    def steady(self, text: str) -> str:
        """The text with its addresses numbered; what has been numbered already stays as it is."""
        return _ADDRESS.sub(lambda found: self._number(found[0]), text)

    def _number(self, address: str) -> str:
        shown = self._shown.get(address)
        if shown is None:
            shown = self._shown[address] = f'{FIRST + 16 * self._count:#x}'
            self._shown[shown] = shown
            self._count += 1
        return shown

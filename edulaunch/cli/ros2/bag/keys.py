"""The keys that steer a recording or a playback."""

from __future__ import annotations

from typing import Any

from edulaunch.processes.current import current_process


class Keys:
    """Reads what was pressed, without waiting. In a terminal each comes at once; its own mode comes back at the end."""

    def __init__(self) -> None:
        process = current_process()
        self._input: Any = process.stdin
        self._is_over = False
        if self._input.isatty():
            tty: Any = process.loader.import_module('tty')
            tty.setcbreak(0)

    def pressed(self) -> str:
        """The keys that were pressed since the last look."""
        keys = ''
        while not self._is_over and self._input.is_ready():
            key = self._input.read(1)
            self._is_over = not key
            keys += key
        return keys

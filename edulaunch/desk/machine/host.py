"""A machine that can be shown in a notebook: what its pages need of it, and the pages."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from edulaunch.desk.view import Living
from edulaunch.desk.view.viewer import Viewer
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.sim.loops import outer_loop_set_aside

SHOWN_EVERY_S = 1 / 30
SHOWN_FOR_S = 1.5
"""How long a page is kept up to date after it asked for it."""


class Page:
    """One page that shows the machine: kept up to date for a while after it asked."""

    def __init__(self, viewer: Viewer) -> None:
        self.viewer = viewer
        self._until_s = self._next_s = 0.0

    def ask(self) -> None:
        """The page is there, and wants to know what is new."""
        self._until_s = time.monotonic() + SHOWN_FOR_S

    def is_shown(self) -> bool:
        """Whether somebody looks at it."""
        return time.monotonic() < self._until_s

    def show(self) -> None:
        """Say what is new, if it is time to."""
        now_s = time.monotonic()
        if self._next_s <= now_s < self._until_s:
            self._next_s = now_s + SHOWN_EVERY_S
            self.viewer.show()


class Host(Living):
    """The machine behind a widget: what a viewer needs, and where it runs.

    :ivar pages: those that show it, each told what is new as time passes.
    """

    pages: list[Page]

    def soon(self, action: Callable[[], object]) -> None:
        """Do something where the machine runs; from any thread."""
        raise NotImplementedError

    def do_for(self, viewer: Viewer, words: dict[str, Any]) -> None:
        """What the page of a viewer asks for."""
        with outer_loop_set_aside(), streams_of_programs():
            viewer.take(words)

"""The live view: one page that shows a machine or a recording, and lets a student pause it, step it and look back.

`timeline` turns a recording into plain data, one delta after the other; `page` is the front end that draws it. The same
page appears in a notebook, beside a terminal, in an exported file and in a report of `edugrade`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.sim.pacing import RealTime
    from edulaunch.runtime.session import Session

TABS = ('launch', 'frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal')
"""The tabs beside the turtles."""


class ViewedMachine:
    """The machine behind a page: its session and its time. These methods are the defaults for machines that lack an ability.

    :ivar session: the session that runs on it.
    :ivar time: how its time passes.
    """

    session: Session
    time: RealTime
    steps_launches = False
    """Whether new launches stop before their first action."""
    can_continue = False
    """Whether the machine can return to any instant."""

    @property
    def is_on_network(self) -> bool | None:
        """Return whether it has joined a real network, or None if it cannot because its time is not real time."""
        return None

    def join_network(self, joins: bool) -> str:
        """Join a real network, or leave it; return a message."""
        return 'only the shared machine can join a network: type `edulaunch network on` in a terminal'

    def recording(self) -> Recording:
        """Return the recording so far; the machine continues."""
        return self.session.snapshot()

    def record_request(self, words: dict[str, Any]) -> None:
        """Accept a request from a page, and record nothing: this machine cannot go back to a past instant."""

    def continue_at(self, time_s: float) -> None:
        """Continue from a past instant. This is not possible if other terminals have typed in the meantime."""

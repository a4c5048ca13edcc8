"""The live desk: one page that shows a machine or a recording, and lets a student stop it, step it and look back.

`timeline` turns what was recorded into plain data, one delta after the other; `page` is the front end that draws it. The same
page stands in a notebook, beside a terminal, in an exported file and in a report of `edugrade`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.sim.pacing import RealTime
    from edulaunch.runtime.session import Session

TABS = ('launch', 'frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal')
"""What can stand beside the turtles."""


class ViewedMachine:
    """The machine behind a page: its session, and how its time passes. What not every machine can is answered here.

    :ivar session: what runs on it.
    :ivar time: how its time passes.
    """

    session: Session
    time: RealTime
    steps_launches = False
    """Whether a launch that begins stops before its first action."""
    can_continue = False
    """Whether any instant can be reached again."""

    @property
    def is_on_network(self) -> bool | None:
        """Whether real nodes can meet those of this machine; None where it cannot join a network: its clock is not the wall's."""
        return None

    def join_network(self, joins: bool) -> str:
        """Join a real network, or leave it; returns what to say."""
        return 'only the machine of the terminals can join a network: edulaunch network on'

    def recording(self) -> Recording:
        """What happened until now; the machine goes on."""
        return self.session.snapshot()

    def record_request(self, words: dict[str, Any]) -> None:
        """A page asked for this."""

    def continue_at(self, time_s: float) -> None:
        """Go on from an instant that has passed; not where others have typed meanwhile."""

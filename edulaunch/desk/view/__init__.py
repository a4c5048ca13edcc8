"""The live view: one page that shows a machine or a recording. A student can pause, step, and go back in time on this page.

`timeline` converts a recording to plain data, one delta after another. `page` builds the front end that draws the data. The same
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
    """The machine that a page shows. The methods here are the defaults for machines that lack an ability.

    :ivar session: the session that the machine runs.
    :ivar time: how simulated time follows real time.
    """

    session: Session
    time: RealTime
    steps_launches = False
    """Whether new launches stop before their first action."""
    can_continue = False
    """Whether the machine can return to any instant."""

    @property
    def is_on_network(self) -> bool | None:
        """Return whether the machine has joined a real network.

        Return None if the machine cannot join, because it does not run in real time.
        """
        return None

    def join_network(self, joins: bool) -> str:
        """Join a real network, or leave it. Return a message for the user.

        :param joins: whether to join; otherwise, leave.
        """
        return 'only the shared machine can join a network: type `edulaunch network on` in a terminal'

    def recording(self) -> Recording:
        """Return a recording of the run so far. The machine continues to run."""
        return self.session.snapshot()

    def record_request(self, words: dict[str, Any]) -> None:
        """Do nothing. A machine that can go back to a past instant records the request here."""

    def continue_at(self, time_s: float) -> None:
        """Continue from a past instant. A machine that several terminals share cannot do this.

        :param time_s: simulated seconds since the start.
        """

"""The simulation of a lesson's turn, with the parts that the rubric hides from the student.

These parts are programs that cannot start, and messages of the grader. For an exercise, the trusted peer adds them.
"""

from __future__ import annotations

import errno
import os
import signal
from functools import partial
from typing import Any, NamedTuple

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.processes.host import Host
from edulaunch.runtime.first_starts import FirstStarts
from edulaunch.runtime.session import Session

from .evidence import Scenario
from .library.launched import VISITOR

ENDED_S = 1.0  # simulated seconds of a run after the end of a program


class _Visitor(NamedTuple):
    """The program of the grader's node."""

    name: str = VISITOR
    pid: int = 0


class TurnHost(FirstStarts, Host):
    """Starts programs, except those whose first start fails."""

    def start(self, spec: Any, *others: Any, **more: Any) -> Any:
        """Start a program like `Host.start`.

        :raises BlockingIOError: for the first start of a program in `fails`, as if the computer had too many processes.
        """
        known = self.known_command(spec, more.get('index'))
        program = known.program if known is not None else None
        name = program.executable if program is not None else ' '.join(spec.argv if known is None else known.argv)
        if self.refuses(name):
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        return super().start(spec, *others, **more)


class TurnSession(Session):
    """The session of a turn."""

    host_class = TurnHost
    host: TurnHost

    def hide(self, scenario: Scenario) -> None:
        """Prepare the programs that must fail, and the messages that the grader sends in a run."""
        self.host.fails = list(scenario.fails)
        for topic, (time_s, text) in scenario.sent.items():
            self.sim.schedule(self.sim.start_ns + round(time_s * 1e9), partial(self._visit, topic, text))

    def end(self, executable: str) -> None:
        """Send SIGINT to the programs of an executable, as Ctrl-C does, and continue the run for ENDED_S simulated seconds."""
        for process in list(self.host.processes):
            if process.spec.executable == executable:
                process.send_signal(signal.SIGINT)
        self.run(ENDED_S)

    def _visit(self, topic: str, text: str) -> None:
        node = self.graph.add_node(_Visitor(), 'visitor', '/')
        publisher = self.graph.create_publisher(node, topic, underlay_registry().get('std_msgs/msg/String'), QoS())
        publisher.publish((text,))

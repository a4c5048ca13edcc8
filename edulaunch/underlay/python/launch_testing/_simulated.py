"""A launch test in a simulation of its own: what `launch_test FILE` and the pytest plugin both use."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Sequence
from types import FrameType
from typing import TYPE_CHECKING, Any

from edulaunch.errors import UnusableInput
from edulaunch.processes.process import Process
from edulaunch.processes.spec import ProcessSpec
from edulaunch.processes.streams import streams_of_programs
from edulaunch.session import Session
from edulaunch.sim.pacing import Pacer
from edulaunch.testing import workspaces_of

if TYPE_CHECKING:
    from .launch_test import LaunchTest

LONGEST_TEST_S = 3600.0


def run_launch_test(
    test: LaunchTest, *, workspaces: Sequence[str] | None = None, seed: int = 0, body: Callable[[], int] | None = None
) -> int:
    """Run a launch test in a fresh simulation; its console goes to this program's own.

    :param workspaces: folders with packages; None: the workspace in which the test file lies.
    :param body: what the process does; None: `test.run`.
    :returns: 0 when all went well. What went wrong else is in `test.results` and `test.error`.
    """
    words = ['launch_test', test.path, *test.arguments]
    with Session(seed=seed, workspaces=workspaces_of(test.path) if workspaces is None else workspaces) as session:
        spec = ProcessSpec(argv=tuple(words), name='launch_test')
        process = Process(session.host, spec, session.host.next_pid(), words, lambda _: (body or test.run)())
        process.on_output = _print
        process.loader.roots += session.index.python_roots()
        session.host.adopt(process)
        _Runner(session, process).run()
        if process.returncode is None:
            test.error = UnusableInput(
                f'{os.path.basename(test.path)}: the launch test was still waiting '
                f'after {session.sim.elapsed_s:.1f} s of simulated time.',
                help='give waits a timeout, such as event.wait(timeout=10)',
            )
        return 1 if process.returncode is None else process.returncode


def _print(stream: str, text: str) -> None:
    target = sys.stdout if stream == 'stdout' else sys.stderr
    target.write(text)
    target.flush()


class _Runner:
    """Runs the simulation until a process has ended; Ctrl-C ends the run, a second one also a program that never waits."""

    def __init__(self, session: Session, process: Process) -> None:
        self._session = session
        self._process = process
        self._pressed = False

    def run(self) -> None:
        """Run.

        :raises KeyboardInterrupt: after Ctrl-C.
        """
        sim = self._session.sim
        in_main = threading.current_thread() is threading.main_thread()
        before: Any = signal.signal(signal.SIGINT, self._press) if in_main else None
        try:
            with streams_of_programs():
                Pacer(sim, 0).run(sim.now_ns + round(LONGEST_TEST_S * 1e9), self._is_over)
        finally:
            if in_main:
                signal.signal(signal.SIGINT, before)
        if self._pressed:
            raise KeyboardInterrupt

    def _press(self, signum: int, frame: FrameType | None) -> None:
        if self._pressed:
            raise KeyboardInterrupt
        self._pressed = True

    def _is_over(self) -> bool:
        return self._pressed or self._process.returncode is not None

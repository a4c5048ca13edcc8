"""Runs the scenarios of a rubric, each in a child process, as many at once as there are processors."""

from __future__ import annotations

import os
import selectors
from collections.abc import Sequence

from .child_run import ChildRun
from .job import Job
from .limits import Limits
from .outcome import Outcome
from .scenario import Scenario
from .submission import Submission
from .verdicts import verdict

LONGEST_NAP_S = 0.05


class Runner:
    """Starts the runs when it is made; `wait` gives the outcomes. Leaving its ``with`` ends every child.

    :param workspaces: folders with the student's packages.
    """

    def __init__(
        self,
        submission: Submission,
        scenarios: Sequence[Scenario],
        limits: Limits | None = None,
        workspaces: Sequence[str] = (),
    ) -> None:
        self._submission = submission
        self._scenarios = list(scenarios)
        self._limits = limits or Limits()
        self._workspaces = workspaces
        self._home = _private_folder()
        self._waiting = list(scenarios)
        self._running: list[ChildRun] = []
        self._outcomes: dict[str, Outcome] = {}
        self._selector = selectors.DefaultSelector()
        self._start_some()

    def __enter__(self) -> Runner:
        return self

    def __exit__(self, *raised: object) -> None:
        for run in self._running:
            run.end()
        self._selector.close()
        import shutil

        shutil.rmtree(self._home, ignore_errors=True)

    def wait(self) -> list[Outcome]:
        """The outcome of each scenario, in the rubric's order."""
        while self._running:
            for key, _ in self._selector.select(LONGEST_NAP_S):
                run: ChildRun = key.data
                read = run.read_channel if key.fileobj == run.channel else run.read_output
                if not read():
                    self._selector.unregister(key.fileobj)
            for run in list(self._running):
                run.watch_the_clock()
                if run.finished:
                    self._finish(run)
        return [self._outcomes[scenario.name] for scenario in self._scenarios]

    def _start_some(self) -> None:
        while self._waiting and len(self._running) < (os.cpu_count() or 1):
            scenario = self._waiting.pop(0)
            home = os.path.join(self._home, str(len(self._outcomes) + len(self._running)))
            os.mkdir(home)
            run = ChildRun(Job(self._submission, scenario, self._limits, self._workspaces, home))
            self._running.append(run)
            for end in (run.channel, run.output):
                self._selector.register(end, selectors.EVENT_READ, run)

    def _finish(self, run: ChildRun) -> None:
        self._running.remove(run)
        for end in (run.channel, run.output):
            if end in self._selector.get_map():
                self._selector.unregister(end)
        run.end()
        self._start_some()
        self._outcomes[run.scenario.name] = verdict(run)


def _private_folder() -> str:
    """A new folder that only this user can enter."""
    folder = os.path.join(os.environ.get('TMPDIR') or '/tmp', f'edugrade-{os.urandom(8).hex()}')
    os.mkdir(folder, 0o700)
    return folder

"""Runs scenarios in this process, one after the other, where a process cannot fork: on Windows, and in a browser.

A submission has all rights of the user and can change the grader. So use this only for the user's own files, and not for marks.
Recordings are the same as in a confined run, except that late starts, messages and turns of the grader are missing.
"""

from __future__ import annotations

import collections
import os
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

from edulaunch.errors import UnusableInput

from .evidence import Outcome, Scenario
from .job import GradingJob, Limits
from .places import environment
from .submission import Submission

if TYPE_CHECKING:
    from collections import Counter

    from edulaunch.runtime.session import Session

STATE = {'the submission': 'this system cannot: only grade your own files here'}
"""The report on each layer of confinement."""
NEEDED = 'grade on a Linux, for which WSL and GitHub Codespaces are good, too'


class InPlace:
    """A runner that runs a submission in this process when a caller waits for it. It has the interface of `Runner`.

    :param limits: the limits of each run, of which only `sandbox` has an effect.
    :param on_outcome: called when a run has ended.
    """

    def __init__(self, limits: Limits | None = None, on_outcome: Callable[[], object] | None = None) -> None:
        self._limits = limits or Limits()
        self._on_outcome = on_outcome
        self._given: dict[int, tuple[Submission, list[str]]] = {}

    def __enter__(self) -> InPlace:
        return self

    def __exit__(self, *raised: object) -> None:
        self._given.clear()

    def add(
        self, submission: Submission, scenarios: Sequence[Scenario], workspaces: Sequence[str] = (), is_next: bool = False
    ) -> GradingJob:
        """Store the runs of a submission until a caller waits for them. The parameters are those of `Runner.add`."""
        job = GradingJob(scenarios)
        self._given[id(job)] = submission, [os.path.abspath(folder) for folder in (*workspaces, *submission.workspaces)]
        return job

    def fault(self) -> str | None:
        """Return None, because this runner does not test the computer."""
        return None

    def wait(self, job: GradingJob) -> list[Outcome]:
        """Run the scenarios of a submission, and return their outcomes in the rubric's order."""
        submission, workspaces = self._given.pop(id(job))
        return [self._outcome(scenario, submission, workspaces) for scenario in job.scenarios]

    def _outcome(self, scenario: Scenario, submission: Submission, workspaces: list[str]) -> Outcome:
        if self._limits.sandbox == 'require':
            outcome = Outcome(scenario, 'broke', text='this system cannot confine a run', try_=NEEDED)
        else:
            outcome = _run(scenario, submission, workspaces)
        if self._on_outcome is not None:
            self._on_outcome()
        return outcome._replace(sandbox=STATE)


def _run(scenario: Scenario, submission: Submission, workspaces: list[str]) -> Outcome:
    from edulaunch.runtime.session import Session

    from .verdicts import come_to

    try:
        with _folder() as home, Session(seed=scenario.seed, workspaces=workspaces, env=environment(home)) as session:
            session.launch(submission.file, None, dict(scenario.arguments))
            session.run(scenario.duration_s)
            outcome = come_to(scenario, session.recording())
            return outcome._replace(bags=_bags(session, outcome, home)) if scenario.is_interrupted else outcome
    except UnusableInput as error:
        return Outcome(scenario, 'unusable', text=error.message, try_=error.help or None)
    except Exception as error:
        text = f'the simulation failed: {type(error).__name__}: {error}'
        return Outcome(scenario, 'broke', text=text, detail=traceback.format_exc())


def _bags(session: Session, outcome: Outcome, home: str) -> list[dict[str, Any]]:
    """Return the contents of the bags that programs write after Ctrl-C."""
    from edulaunch.engine.interfaces import current_registry
    from edulaunch.ros.serialization.cdr import encode

    from .sandbox.bags import written_bags

    def published(topic: str) -> Counter[bytes]:
        recording, registry = outcome.recording, current_registry()
        found: Counter[bytes] = collections.Counter()
        for column in recording.rows('topics') if recording else ():
            if column['topic'] == topic:
                found.update(encode(registry.get(column['type']), wire) for wire in column['messages'])
        return found

    end_ns = session.sim.now_ns
    session.interrupt()
    session.run(2.0)
    return written_bags(home, end_ns, published)


@contextmanager
def _folder() -> Iterator[str]:
    """Create a private folder and enter it. Afterwards, restore this process's current folder and module search path."""
    import shutil
    import tempfile

    here, path = os.getcwd(), list(sys.path)
    home = tempfile.mkdtemp(prefix='edugrade-')
    os.chdir(home)
    try:
        yield home
    finally:
        sys.path[:] = path
        with suppress(OSError):
            os.chdir(here)
        shutil.rmtree(home, ignore_errors=True)

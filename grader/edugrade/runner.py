"""Runs scenarios of submissions in child processes, with one parallel run for each processor."""

from __future__ import annotations

import errno
import os
import selectors
from collections.abc import Callable, Sequence
from time import monotonic
from typing import Any

from .child_run import ChildRun
from .evidence import Outcome, Scenario
from .faults import SENTENCES, ComputerFault, fault_here, fault_of, killed_for_memory, looks_like_one, no_mark_for
from .job import GradingJob, Limits, RunRequest
from .sandbox.remove_tree import remove_tree
from .starter_link import StarterLink, private_folder, take_early
from .submission import Submission
from .verdicts import verdict
from .worker import attended

LONGEST_NAP_S = 0.05
SOON_S = 2.0
MOST_STARTS = 20  # attempts at a run whose starter was killed before it read anything of the submission
MOST_TIMES_AGAIN = 2  # repetitions of a run that was killed, because another submission may be the cause


class Runner:
    """A runner that starts each run as soon as a processor is free. At the end of its ``with`` block, it ends every child.

    :param limits: the limits of each child.
    :param on_outcome: called when a run has ended.
    :param processors: the number of parallel runs (default: the number of processors).
    :param is_for_many: whether many submissions are expected, so that the starter loads more before the first run.
    """

    def __init__(
        self,
        limits: Limits | None = None,
        on_outcome: Callable[[], object] | None = None,
        processors: int | None = None,
        is_for_many: bool = False,
    ) -> None:
        self._is_for_many = is_for_many
        self._limits = limits or Limits()
        self._processors = processors or os.cpu_count() or 1
        self._on_outcome = on_outcome
        self._starter: StarterLink | None
        self._home, self._starter = take_early() or (_private_folder(), None)
        self._waiting: list[tuple[GradingJob, Scenario, Submission, Sequence[str]]] = []
        self._running: dict[ChildRun, GradingJob] = {}
        self._started = 0
        self._killed_for_memory = killed_for_memory()
        self._listened_at = monotonic()
        self._selector = selectors.DefaultSelector()
        self._attended = attended(self._attend)

    def __enter__(self) -> Runner:
        self._attended.__enter__()
        return self

    def __exit__(self, *raised: object) -> None:
        self._attended.__exit__(None, None, None)
        for run in self._running:
            run.end()
        if self._starter is not None:
            self._starter.close()
        self._selector.close()
        remove_tree(self._home)

    def add(
        self, submission: Submission, scenarios: Sequence[Scenario], workspaces: Sequence[str] = (), is_next: bool = False
    ) -> GradingJob:
        """Request the runs of a submission, and return the job. Earlier requests run first, unless `is_next` is set.

        :param workspaces: additional folders with the student's packages, which are searched before the packages of the
            submission.
        """
        job = GradingJob(scenarios)
        folders = [*workspaces, *submission.workspaces]
        place = 0 if is_next else len(self._waiting)
        self._waiting[place:place] = [(job, scenario, submission, folders) for scenario in scenarios]
        self._start_some()
        return job

    def homes(self) -> list[str]:
        """Return the private folders of the runs so far. Each folder is removed when its run has ended."""
        return [os.path.join(self._home, str(number + 1)) for number in range(self._started)]

    def wait(self, job: GradingJob) -> list[Outcome]:
        """Wait for the runs of a job, and return their outcomes in the rubric's order. Other runs continue meanwhile."""
        while not job.is_done:
            self._turn(LONGEST_NAP_S)
        return [job.outcomes[scenario.name] for scenario in job.scenarios]

    def _attend(self, end: int, seconds: float) -> bool:
        """Continue the runs while a worker judges. Return whether `end` is readable, at the latest after `seconds`."""
        self._selector.register(end, selectors.EVENT_READ, lambda: True)
        try:
            return end in self._turn(seconds)
        finally:
            self._forget(end)

    def _turn(self, seconds: float) -> list[Any]:
        """Wait for readable pipes and sockets, read from them, and return them."""
        ready = self._listen(seconds)
        for key, _ in ready:
            if not key.data():
                self._forget(key.fileobj)
        for child in list(self._running):
            child.watch()
            if child.finished:
                self._finish(child)
        return [key.fileobj for key, _ in ready]

    def _listen(self, seconds: float) -> list[tuple[selectors.SelectorKey, int]]:
        """Return the readable pipes and sockets. The time in which the grader judged a submission extends the deadline of each
        run.
        """
        for run in self._running:
            run.deadline += monotonic() - self._listened_at
        ready = self._selector.select(seconds)
        self._listened_at = monotonic()
        return ready

    def _start_some(self) -> None:
        while self._waiting and len(self._running) < self._processors:
            job, scenario, submission, workspaces = self._waiting.pop(0)
            self._started += 1
            home = os.path.join(self._home, str(self._started))
            try:
                os.mkdir(home)
                run = ChildRun(RunRequest(submission, scenario, self._limits, workspaces, home), self._living_starter())
            except OSError as error:
                self._settle(
                    job, no_mark_for(Outcome(scenario, 'broke', text=str(error), sandbox=None), fault_of(error) or str(error))
                )
                continue
            self._running[run] = job
            for end, read in ((run.channel, run.read_channel), (run.output, run.read_output), (run.link, run.read_link)):
                self._selector.register(end, selectors.EVENT_READ, read)

    def _living_starter(self) -> StarterLink:
        """Return the starter, or a new starter if the last one has ended."""
        if self._starter is None or not self._starter.is_alive:
            if self._starter is not None:
                self._starter.close()
            home = os.path.join(self._home, f'starter{self._started}')
            os.mkdir(home)
            self._starter = StarterLink(home)
        self._starter.is_for_many = self._is_for_many
        return self._starter

    def _forget(self, end: Any) -> None:
        """Stop waiting for this end of a pipe or socket."""
        if end in self._selector.get_map():
            self._selector.unregister(end)

    def _finish(self, run: ChildRun) -> None:
        job = self._running.pop(run)
        for end in (run.channel, run.output, run.link):
            self._forget(end)
        run.end()
        remove_tree(run.home)
        outcome = None if run.was_killed else verdict(run)
        most = _times_again(run, outcome)
        if most > job.again[run.scenario.name]:
            job.again[run.scenario.name] += 1
            run.starter.is_alive = run.starter.is_alive and (run.has_begun or run.complete)  # its own one
            self._waiting.insert(0, (job, run.scenario, run.submission, run.workspaces))
            self._start_some()
            return
        self._start_some()
        found = (outcome or verdict(run))._replace(real_s=monotonic() - run.begun_at)
        self._settle(job, self._unless_spoilt(found) if most else found)

    def _unless_spoilt(self, outcome: Outcome) -> Outcome:
        """Return the outcome of a run that has failed repeatedly. If the computer is the cause, the outcome has no mark."""
        fault = fault_here(self._home)
        if fault is None and killed_for_memory() > self._killed_for_memory:
            fault = SENTENCES[errno.ENOMEM]
        return outcome if fault is None else no_mark_for(outcome, fault)

    def _settle(self, job: GradingJob, outcome: Outcome) -> None:
        job.outcomes[outcome.scenario.name] = outcome
        if self._on_outcome is not None:
            self._on_outcome()

    def fault(self) -> str | None:
        """Return a sentence about what this computer cannot provide for runs now, or None if nothing is missing."""
        return fault_here(self._home)


def _times_again(run: ChildRun, outcome: Outcome | None) -> int:
    """Return how many times a run may be repeated. It may have been killed, have ended early, or have met a fault of the
    computer.
    """
    if outcome is None:
        return MOST_TIMES_AGAIN if run.has_begun else MOST_STARTS
    if looks_like_one(outcome):
        return MOST_TIMES_AGAIN
    return int(outcome.recording is None and run.cut in (None, 'garbage') and monotonic() - run.begun_at < SOON_S)


def _private_folder() -> str:
    """Return a new folder that only this user can enter.

    :raises ComputerFault: if the folder cannot be created.
    """
    try:
        return private_folder()
    except OSError as error:
        place = os.path.dirname(error.filename)
        why = SENTENCES.get(error.errno or 0, error.strerror)
        raise ComputerFault(f'there is no folder for temporary files in {place}: {why}') from None

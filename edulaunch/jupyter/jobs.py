"""What a notebook left running with `&`."""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.errors import UnusableInput
from edulaunch.processes.process import Process


class Job(NamedTuple):
    """One of them, numbered as a shell does."""

    number: int
    process: Process
    text: str

    def __str__(self) -> str:
        code = self.process.returncode
        state = 'Running' if code is None else 'Done' if code == 0 else f'Exit {code}'
        return f'[{self.number}]  {self.process.pid}  {state:<10}{self.text}'


class Jobs:
    """All of them, in the order in which they were started."""

    def __init__(self) -> None:
        self._jobs: list[Job] = []

    def add(self, process: Process, text: str) -> Job:
        """One more."""
        self._jobs.append(Job(max((job.number for job in self._jobs), default=0) + 1, process, text))
        return self._jobs[-1]

    def running(self) -> list[Job]:
        """Those that have not ended."""
        return [job for job in self._jobs if job.process.returncode is None]

    def chosen(self, number: str) -> list[Job]:
        """All, or the one of that number.

        :raises UnusableInput: when there is none.
        """
        found = [job for job in self._jobs if number in ('', str(job.number), f'%{job.number}')]
        if number and not found:
            known = ', '.join(str(job.number) for job in self._jobs)
            raise UnusableInput(f'there is no job {number}', help=f'jobs: {known}' if known else 'nothing was started with &')
        return found

    def forget_ended(self) -> None:
        """As a shell does once it has told of them."""
        self._jobs = self.running()

    def clear(self) -> None:
        """The machine is gone."""
        self._jobs.clear()

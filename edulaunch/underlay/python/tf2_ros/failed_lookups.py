"""Lookups that found nothing, until they find something: facts in plain data, of which advice is made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.processes.current import current_process
from edulaunch.processes.student_line import student_line

if TYPE_CHECKING:
    from edulaunch.tf import TransformBuffer

KIND = 'lookup failed'
MOST_FRAMES = 40


class FailedLookups:
    """Those of one buffer, by target and source frame.

    :param number: which one it is of its program's buffers.
    """

    def __init__(self, number: int) -> None:
        self._number = number
        self.pairs: set[tuple[str, str]] = set()

    def note(
        self, buffer: TransformBuffer, target: str, source: str, time_ns: int, kind: str, text: str, waited_s: float = 0.0
    ) -> None:
        """There was no answer; `kind` is that of the failure, `text` tf2's own; `waited_s` the time limit it had."""
        process = current_process()
        self.pairs.add((target, source))
        names = buffer.frame_names()
        data = {
            'target': target,
            'source': source,
            'why': kind,
            'text': text,
            'asked_s': (time_ns - process.sim.start_ns) / 1e9 if time_ns else None,
            'unknown': [name for name in dict.fromkeys((target, source)) if not buffer.frame_exists(name)],
            'frames': names[:MOST_FRAMES],
            'waited_s': waited_s,
        }
        process.fact(KIND, (self._number, target, source), {**data, **student_line()})

    def found(self, target: str, source: str) -> None:
        """Now there is an answer: all is well."""
        if (target, source) in self.pairs:
            self.pairs.remove((target, source))
            current_process().fact_over(KIND, (self._number, target, source))


def of_next_buffer() -> FailedLookups:
    """Those of a new buffer of the running program."""
    state = current_process().state
    state['tf2_ros.buffers'] = number = state.get('tf2_ros.buffers', 0) + 1
    return FailedLookups(number)

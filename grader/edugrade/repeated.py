"""Checks whether a run repeats: the grader runs a student's own nodes twice, and compares the recordings."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

from .evidence import Outcome, Scenario
from .results import FAILED, PASSED, REPEATS, CheckResult
from .shortened import shortened
from .source import SubmittedText, comes_with_edulaunch
from .worker import TooLong, cpu_limit

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

SENTENCE = 'Two runs of the same launch are identical'
LONGEST_SEARCH_S = 5.0
LONGEST_DIGEST_S = 5.0  # the digest usually takes a hundredth of this
LONGEST_SHOWN = 200
COMMANDS = ('ros2',)  # programs that do not belong to a node of the student


def has_own_programs(recording: Recording) -> bool:
    """Return whether a run contains programs that do not come with edulaunch."""
    for process in recording.processes:
        own = process.package is not None and not comes_with_edulaunch(process.package)
        script = (
            process.package is None and bool(process.argv) and os.path.basename(process.argv[0].split(' ')[0]) not in COMMANDS
        )
        if process.name != 'launch' and (own or script):
            return True
    return False


def difference(one: Outcome, two: Outcome) -> str | None:
    """Return the first difference between two runs of one scenario, in words, or None if they are identical."""
    if two.recording is None:
        return f'the second run did not finish: {two.text}'
    if one.recording is None or digest_of(one) == digest_of(two):
        return None
    try:
        with cpu_limit(LONGEST_SEARCH_S):
            return _first(one.recording, two.recording) or 'the recordings differ'
    except (TooLong, ValueError, TypeError, AttributeError, LookupError):
        return 'the recordings differ'


def digest_of(outcome: Outcome) -> str | None:
    """Return the digest of a recording. Return None if there is no recording, or if computing its digest takes too long or
    fails.
    """
    try:
        with cpu_limit(LONGEST_DIGEST_S):
            return None if outcome.recording is None else outcome.recording.digest()
    except (
        TooLong,
        ValueError,
        TypeError,
        AttributeError,
        LookupError,
        RecursionError,
    ):  # a hostile recording can make its reader raise these
        return None


def result(differences: Sequence[tuple[Scenario, str | None]], source: SubmittedText) -> CheckResult:
    """Return the result that states whether the runs repeat. The result has no points.

    :param differences: for each scenario, the first difference or None.
    """
    found = next(((scenario, words) for scenario, words in differences if words), None)
    if found is None:
        return CheckResult(REPEATS, SENTENCE, PASSED)
    return CheckResult(
        REPEATS,
        SENTENCE,
        FAILED,
        reason=f'two runs with {found[0].words} differ',
        expected='the same messages at the same simulated times',
        seen=found[1],
        where=source.place,
        try_='use node.get_clock() and the module random instead of real time, os.urandom and addresses',
    )


def _first(one: Recording, two: Recording) -> str | None:
    pairs = [_first_pair(_events(one), _events(two)), _first_pair(_texts(one), _texts(two))]
    found = [pair for pair in pairs if pair is not None]
    return min(found)[1] if found else None


def _first_pair(one: Iterator[tuple[float, str, Any]], two: Iterator[tuple[float, str, Any]]) -> tuple[float, str] | None:
    for here, there in zip_longest(one, two):
        if here != there:
            known = [event for event in (here, there) if event is not None]
            first = min(known, key=lambda event: event[:2])
            shown = [_short(event[2]) if event is not None and event[:2] == first[:2] else 'nothing' for event in (here, there)]
            return first[0], f'at {first[0]:.3f} s, {first[1]}: {shown[0]} in the first run, {shown[1]} in the second'
    return None


def _events(recording: Recording) -> Iterator[tuple[float, str, Any]]:
    """Return all messages, sorted by time and topic."""
    found = [
        (time_ns / 1e9, f'a message on {topic.name}', repr(wire))
        for topic in recording.topics.values()
        for time_ns, wire in recording.wires(topic.name, topic.type)
    ]
    return iter(sorted(found, key=lambda event: event[:2]))


def _texts(recording: Recording) -> Iterator[tuple[float, str, Any]]:
    """Yield the output and the exit codes of the programs."""
    yield from ((item.time_s, f'{item.process} prints', repr(item.text)) for item in recording.output)
    yield from ((item.ended_s or 0.0, f'{item.name} ends', repr(item.returncode)) for item in recording.processes)


def _short(text: str) -> str:
    return text if len(text) <= LONGEST_SHOWN else f'{shortened(text, LONGEST_SHOWN)} ...'

"""Decide which differences count, and which are only information because they depend on the speed of the computer.

A busy computer starts programs late, repeats actions less often, and may not have done everything in time. So these differences
are only information: rates, lines about waiting or about a missing transform, and events that the real run may still reach later.
An event that the real run lacks counts when it is overdue: see :func:`is_overdue`.
"""

from __future__ import annotations

import re
from collections import Counter

from edulaunch.extras.comparing.differing import MISSING, NOT_THERE, Difference
from edulaunch.extras.comparing.observation import Observation, program_of

SLOWNESS = 2.0
"""How many times as long as the simulation a real run may take."""
SPARE_S = 5.0
"""The additional seconds that a real run may need, without the time in which its programs started."""
_WAITING = re.compile(r'\b(still )?wait(s|ing)?\b', re.IGNORECASE)
_NOT_YET = re.compile(r'extrapolation|does not exist|not part of the same tree|[Cc]ould not (find a connection|transform)')
"""The messages of tf2 before a transform has arrived."""


def is_pace(difference: Difference) -> bool:
    """Return whether a line only reports how often something happened, or that a program waits."""
    kind, _, here, there, _ = difference
    if kind != 'output':
        return kind.startswith('rate of ')
    return bool(_WAITING.search(here if there == MISSING else there) or (here == MISSING and _NOT_YET.search(there)))


def informs(difference: Difference, simulated: Observation, real: Observation, late_s: float) -> bool:
    """Return whether a difference is only information, because it depends on the speed of the computer.

    :param late_s: the additional time, in seconds, that the last program needed to start in the real run.
    """
    if is_pace(difference):
        return True
    if difference.lacks:
        return not _has_as_many(difference, simulated, real)
    return difference.real in NOT_THERE and not is_overdue(difference, simulated, real, late_s)


def is_overdue(difference: Difference, simulated: Observation, real: Observation, late_s: float) -> bool:
    """Return whether the real run had enough time for the missing event, or its program has continued past that event."""
    if difference.kind == 'output' and _is_past(difference.name, difference.simulated, simulated, real):
        return True
    first_s = _first_s(difference, simulated)
    return first_s is not None and SLOWNESS * first_s + late_s + SPARE_S <= real.asked_s


def _is_past(process: str, text: str, simulated: Observation, real: Observation) -> bool:
    """Return whether the real program printed a line that the simulated program first prints, or repeats, after the given
    line.
    """
    printed = sorted((line for line in simulated.lines if line.process == process), key=lambda line: line.time_s)
    texts = [line.text for line in printed]
    if text not in texts:
        return False
    before = Counter(texts[: texts.index(text)])
    after = Counter(line.text for line in real.lines if line.process == process and not _WAITING.search(line.text))
    return any(after[each] > count + 1 for each, count in before.items()) or any(
        after[each] for each in texts[texts.index(text) + 1 :] if each != text and each not in before
    )


def _has_as_many(difference: Difference, simulated: Observation, real: Observation) -> bool:
    """Return whether the real run had at least as many messages as the simulation until Ctrl-C."""
    topic = difference.name.rpartition(' ')[0]
    names = (f'tf {topic}', topic)
    here, there = (next((seen.flows[name].times for name in names if name in seen.flows), []) for seen in (simulated, real))
    return len(there) >= sum(time_s <= simulated.asked_s for time_s in here)


def _first_s(difference: Difference, simulated: Observation) -> float | None:
    """Return when the missing event first occurred in simulation, in seconds, or None if that time is unknown."""
    kind, name, text, *_ = difference
    if kind == 'output':
        times = [line.time_s for line in simulated.lines if (line.process, line.text) == (name, text)]
    elif kind == 'exit code':
        times = [each.ended_s for key, each in simulated.programs.items() if program_of(key) == name and each.ended_s is not None]
    elif kind in ('messages', 'transform'):
        times = simulated.flows[name].times if name in simulated.flows else []
    elif kind == 'node':
        times = [simulated.nodes[name]] if name in simulated.nodes else []
    elif kind == 'parameter':
        return 0.0
    else:
        times = [when for end, (_, when) in simulated.ends.items() if (end.kind, f'{end.name} of {end.node}') == (kind, name)]
    return min(times, default=None)

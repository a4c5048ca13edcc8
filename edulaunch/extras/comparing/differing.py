"""List the differences between simulations and a real run, except differences due to chance.

Real programs take time to start and to find each other, and messages during that time may be lost. The real run need not receive
messages that the simulation published before :data:`FOUND_S`, or before the topic had a real subscription. Rates may differ by a
quarter, and ranges of numbers by a quarter of their length.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator, Sequence
from itertools import permutations
from typing import Any, NamedTuple

from edulaunch.extras.comparing.observation import BRIEFLY, Flow, Line, Observation, Range, Values, program_of

FOUND_S = 3.0
"""The time, in seconds, from which all programs have found each other."""
YOUNG_S = 1.0
SHARE = 0.25
FEWEST, SHORTEST_S = 5, 0.5
"""The number of messages, and the time in seconds, that a rate requires. A busy computer may delay fewer messages."""
MISSING = 'missing'
NOT_THERE = (MISSING, 'none', 'still running')
_CHANCE = (
    'rcl_shutdown already called',
    'Failed to publish log message to rosout',
    "publisher's context is invalid",
    "node's context is invalid",
    'the given context is not valid',
    'feedback publisher is invalid',
    'the client may have gone away',
    'client will not receive response',
    'exception was never retrieved',
    'SystemError: <built-in method ',
    'lost sys.stderr',
    *(f'object {what:9}: ' for what in ('address', 'refcount', 'type', 'repr')),
    'object type name: ',
)
"""Messages that a program may print when Ctrl-C interrupts the program or its peers at a bad moment."""
_CRASHES = (-signal.SIGSEGV, -signal.SIGABRT)
"""The exit codes of a program that was interrupted in C++ code."""


class Difference(NamedTuple):
    """A difference: its kind, its subject, and the state in the simulation and in the real run.

    :ivar lacks: True if the real run lacks values of messages; False if the simulation lacks them.
    """

    kind: str
    name: str
    simulated: str
    real: str
    lacks: bool = False


def differences(simulated: Sequence[Observation], real: Observation) -> list[Difference]:
    """Return every difference of the real run from all simulations, in a fixed order, with the state in the last simulation."""
    found = [_differences(one, real) for one in simulated]
    in_all = set.intersection(*({_about(each) for each in row} for row in found))
    return [each for each in found[-1] if _about(each) in in_all]


def _about(difference: Difference) -> tuple[object, ...]:
    """Return a key that is equal for the same difference in two simulations."""
    kind, name, simulated, real, lacks = difference
    return difference if kind == 'output' else (kind, name, lacks, simulated in NOT_THERE, real in NOT_THERE)


def by_chance(simulated: Sequence[Observation]) -> set[tuple[str, ...]]:
    """Return the subjects that differ between simulations with different seeds, in their values or their presence."""
    pairs = permutations(simulated, 2)
    return {subject(each) for one, other in pairs for each in _differences(one, other)}


def subject(difference: Difference) -> tuple[str, ...]:
    """Return the subject of a difference; for a difference of output, it includes the line."""
    kind, name, simulated, real, _ = difference
    return (kind, name, simulated if real == MISSING else real) if kind == 'output' else (kind, name)


def _differences(simulated: Observation, real: Observation) -> list[Difference]:
    return [
        *_nodes(simulated, real),
        *_ends(simulated, real),
        *_parameters(simulated, real),
        *_flows(simulated, real, simulated.asked_s),
        *_lines(simulated, real),
        *_codes(simulated, real),
    ]


def _nodes(simulated: Observation, real: Observation) -> Iterator[Difference]:
    for node in sorted({*simulated.nodes, *real.nodes}):
        if node not in simulated.nodes:
            yield Difference('node', node, MISSING, 'there')
        elif node not in real.nodes and simulated.nodes[node] <= simulated.asked_s:
            yield Difference('node', node, 'there', MISSING)


def _ends(simulated: Observation, real: Observation) -> Iterator[Difference]:
    types = {(end.kind, end.name, end.node): end.type for end in (*simulated.ends, *real.ends)}
    for kind, name, node in sorted(types):
        here = {end.type: rest for end, rest in simulated.ends.items() if (end.kind, end.name, end.node) == (kind, name, node)}
        there = {end.type: rest for end, rest in real.ends.items() if (end.kind, end.name, end.node) == (kind, name, node)}
        if node not in simulated.nodes or node not in real.nodes:
            continue  # the missing node itself is reported
        if not there and min(when for _, when in here.values()) > simulated.asked_s:
            continue
        what = f'{name} of {node}'
        if here.keys() != there.keys():
            yield Difference(kind, what, ', '.join(sorted(here)) or MISSING, ', '.join(sorted(there)) or MISSING)
        else:
            qos = [(here[each][0], there[each][0]) for each in sorted(here)]
            yield from (Difference(f'QoS of {kind}', what, *pair) for pair in qos if pair[0] != pair[1])


def _parameters(simulated: Observation, real: Observation) -> Iterator[Difference]:
    for node in sorted(simulated.parameters.keys() & real.parameters.keys()):
        here, there = simulated.parameters[node], real.parameters[node]
        for name in sorted({*here, *there}):
            texts = [_shown(values[name]) if name in values else MISSING for values in (here, there)]
            if texts[0] != texts[1]:
                yield Difference('parameter', f'{name} of {node}', texts[0], texts[1])


def _shown(value: Any) -> str:
    return repr(list(value)) if not isinstance(value, (bool, int, float, str, bytes, type(None))) else repr(value)


def _flows(simulated: Observation, real: Observation, late_s: float) -> Iterator[Difference]:
    nothing = Flow([], {})
    for name in sorted({*simulated.flows, *real.flows}):
        here, there = simulated.flows.get(name, nothing), real.flows.get(name, nothing)
        kind = 'transform' if name.startswith('tf ') else 'messages'
        if name not in simulated.flows and there.times:
            yield Difference(kind, name, 'none', str(len(there.times)))
        elif not there.times and any(FOUND_S <= time_s <= late_s for time_s in here.times):
            yield Difference(kind, name, str(len(here.times)), 'none')
        elif here.times and there.times:
            name = name.removeprefix('tf ')
            yield from _rates(kind, name, here, there)
            yield from _values(kind if kind == 'transform' else 'values in messages', name, here, there, late_s)


def _values(kind: str, name: str, here: Flow, there: Flow, late_s: float) -> Iterator[Difference]:
    """Yield the fields with a real value that did not occur in simulation, or without a value that occurred in simulation.

    Only the values since the first real subscription count.
    """
    for path in sorted({*here.fields, *there.fields}):
        one, other = (flow.fields.get(path) or Values() for flow in (here, there))
        needed = one.between(there.times[0], late_s)
        if not _holds(one.range, other.range):
            yield Difference(kind, f'{name} {path}', str(one.range), str(other.range))
        elif not _holds(other.range, needed):
            yield Difference(kind, f'{name} {path}', str(one.range), str(other.range), lacks=True)


def _holds(outer: Range, inner: Range) -> bool:
    if inner.texts:
        return inner.texts <= outer.texts
    if inner.low > inner.high:
        return True  # the array is empty, or there was no message in that time
    spare = SHARE * (outer.high - outer.low) + 1e-6 * max(1.0, abs(outer.high), abs(outer.low))
    return outer.low - spare <= inner.low and inner.high <= outer.high + spare


def _rates(kind: str, name: str, here: Flow, there: Flow) -> Iterator[Difference]:
    flows = (here, there)
    if any(len(flow.times) < FEWEST or flow.times[-1] - flow.times[0] < SHORTEST_S for flow in flows):
        return
    one, other = ((len(flow.times) - 1) / (flow.times[-1] - flow.times[0]) for flow in flows)
    if abs(one - other) > SHARE * max(one, other):
        yield Difference(f'rate of {kind}', name, f'{one:.3g} Hz', f'{other:.3g} Hz')


def not_up(simulated: Observation, real: Observation) -> set[str]:
    """Return the programs that received a signal in the real run before they had started, or at most :data:`YOUNG_S` after
    their start.

    The behaviour of these programs after the signal is a matter of chance.
    """
    found = set()
    for name, program in real.programs.items():
        nodes = simulated.programs[name].nodes if name in simulated.programs else ()
        came_s = min([program.spoke_s, *(real.nodes[node] for node in nodes if node in real.nodes)])
        if program.signalled_s < BRIEFLY and program.signalled_s < came_s + YOUNG_S:
            found.add(program_of(name))
    return found


def _lines(simulated: Observation, real: Observation) -> Iterator[Difference]:
    unlucky = _unlucky(simulated) | _unlucky(real)
    sent, received = (
        {(line.process, line.text) for line in seen.lines if not (line.process in unlucky and _is_last(seen, line))}
        for seen in (simulated, real)
    )
    young = not_up(simulated, real)
    for process, text in sorted(sent ^ received):
        if process not in young:
            yield Difference('output', process, *((text, MISSING) if (process, text) in sent else (MISSING, text)))


def _unlucky(seen: Observation) -> set[str]:
    """Return the programs that a signal interrupted at a bad moment. Their later output and their exit code are a matter of
    chance.
    """
    crashed = {
        program_of(name) for name, each in seen.programs.items() if each.signalled_s < BRIEFLY and each.returncode in _CRASHES
    }
    lines = (line for line in seen.lines if any(words in line.text for words in _CHANCE))
    return crashed | {line.process for line in lines if line.time_s >= _signalled_s(seen, line.process)}


def _signalled_s(seen: Observation, process: str) -> float:
    return min([seen.asked_s, *(each.signalled_s for name, each in seen.programs.items() if program_of(name) == process)])


def _is_last(seen: Observation, line: Line) -> bool:
    """Return whether a line came after the program had received a signal or, in a simulation, after the program had ended."""
    ends = (each.ended_s for name, each in seen.programs.items() if program_of(name) == line.process)
    return line.time_s >= min([_signalled_s(seen, line.process), *(end_s for end_s in ends if end_s is not None)])


def _codes(simulated: Observation, real: Observation) -> Iterator[Difference]:
    chance = _unlucky(simulated) | _unlucky(real) | not_up(simulated, real)
    for program in sorted({*simulated.codes, *real.codes} - chance):
        texts = [
            ', '.join(map(str, sorted(codes.get(program, ())))) or 'still running' for codes in (simulated.codes, real.codes)
        ]
        if texts[0] != texts[1]:
            yield Difference('exit code', program, texts[0], texts[1])

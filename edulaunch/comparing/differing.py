"""What differs between a run in simulation and a run for real, as far as it is no matter of chance.

Real programs take time to start and to find each other, and messages of a start may be lost. So what was seen in simulation
during the last :data:`LATE_S` before Ctrl-C need not have been seen for real, rates may differ by a quarter, and ranges of
numbers by a quarter of their length.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from edulaunch.comparing.observation import Flow, Observation, Range, Values

LATE_S = 5.0
FOUND_S = 3.0
"""From then on everybody has found everybody."""
SHARE = 0.25
FEWEST = 5
"""So many messages make a rate."""
MISSING = 'missing'
_CHANCE = ('rcl_shutdown already called', 'Failed to publish log message to rosout')
"""What a program says when Ctrl-C finds the real rclpy at a bad moment, which may also change its exit code."""


class Difference(NamedTuple):
    """One thing that is not the same: what kind of thing, which, and how it is in each world."""

    kind: str
    name: str
    simulated: str
    real: str


def differences(simulated: Observation, real: Observation) -> list[Difference]:
    """Everything that differs, in a fixed order."""
    late_s = simulated.asked_s - LATE_S
    return [
        *_nodes(simulated, real, late_s),
        *_ends(simulated, real, late_s),
        *_parameters(simulated, real),
        *_flows(simulated, real, late_s),
        *_lines(simulated, real, late_s),
        *_codes(simulated, real),
    ]


def _nodes(simulated: Observation, real: Observation, late_s: float) -> Iterator[Difference]:
    for node in sorted({*simulated.nodes, *real.nodes}):
        if node not in simulated.nodes:
            yield Difference('node', node, MISSING, 'there')
        elif node not in real.nodes and simulated.nodes[node] <= late_s:
            yield Difference('node', node, 'there', MISSING)


def _ends(simulated: Observation, real: Observation, late_s: float) -> Iterator[Difference]:
    types = {(end.kind, end.name, end.node): end.type for end in (*simulated.ends, *real.ends)}
    for kind, name, node in sorted(types):
        here = {end.type: rest for end, rest in simulated.ends.items() if (end.kind, end.name, end.node) == (kind, name, node)}
        there = {end.type: rest for end, rest in real.ends.items() if (end.kind, end.name, end.node) == (kind, name, node)}
        if node not in simulated.nodes or node not in real.nodes:
            continue  # said of the node
        if not there and min(when for _, when in here.values()) > late_s:
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
                yield Difference('parameter', f'{name} of {node}', *texts)


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
    """For real there is nothing that was never so in simulation, and everything that was so in simulation from when somebody
    heard it for real."""
    for path in sorted({*here.fields, *there.fields}):
        one, other = (flow.fields.get(path) or Values() for flow in (here, there))
        needed = one.between(there.times[0], late_s)
        if not (_holds(one.range, other.range) and _holds(other.range, needed)):
            yield Difference(kind, f'{name} {path}', str(one.range), str(other.range))


def _holds(outer: Range, inner: Range) -> bool:
    if inner.texts:
        return inner.texts <= outer.texts
    if inner.low > inner.high:
        return True  # of an array that was empty, or nothing was heard in that time
    spare = SHARE * (outer.high - outer.low) + 1e-6 * max(1.0, abs(outer.high), abs(outer.low))
    return outer.low - spare <= inner.low and inner.high <= outer.high + spare


def _rates(kind: str, name: str, here: Flow, there: Flow) -> Iterator[Difference]:
    if min(len(here.times), len(there.times)) < FEWEST:
        return
    one, other = ((len(flow.times) - 1) / max(1e-9, flow.times[-1] - flow.times[0]) for flow in (here, there))
    if abs(one - other) > SHARE * max(one, other):
        yield Difference(f'rate of {kind}', name, f'{one:.3g} Hz', f'{other:.3g} Hz')


def _lines(simulated: Observation, real: Observation, late_s: float) -> Iterator[Difference]:
    said = {(line.process, line.text) for line in simulated.lines}
    needed = {(line.process, line.text) for line in simulated.lines if line.time_s <= late_s or line.time_s > simulated.asked_s}
    heard = {(line.process, line.text) for line in real.lines}
    for process, text in sorted(needed - heard):
        yield Difference('output', process, text, MISSING)
    for process, text in sorted(heard - said):
        if not _is_chance(text):
            yield Difference('output', process, MISSING, text)


def _is_chance(text: str) -> bool:
    return any(words in text for words in _CHANCE)


def _codes(simulated: Observation, real: Observation) -> Iterator[Difference]:
    unlucky = {line.process for line in real.lines if _is_chance(line.text)}
    for program in sorted({*simulated.codes, *real.codes} - unlucky):
        texts = [
            ', '.join(map(str, sorted(codes.get(program, ())))) or 'still running' for codes in (simulated.codes, real.codes)
        ]
        if texts[0] != texts[1]:
            yield Difference('exit code', program, *texts)

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.extras.comparing.deciding import informs
from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.observation import Flow, Line, Observation, Program

MISSING = 'missing'


def seen(asked_s: float, **parts: Any) -> Observation:
    nothing: dict[str, Any] = {'nodes': {}, 'ends': {}, 'parameters': {}, 'flows': {}, 'lines': [], 'programs': {}}
    return Observation(**{**nothing, 'asked_s': asked_s, **parts})


def output(here: str, there: str) -> Difference:
    return Difference('output', 'a', here, there)


@pytest.mark.parametrize(
    ('difference', 'expected'),
    [
        (output(MISSING, '[INFO] [#] [a]: waiting for service to become available...'), True),
        (output('service not available, waiting again...', MISSING), True),
        (output(MISSING, 'Lookup would require extrapolation into the past'), True),
        (output(MISSING, 'the waiter fell'), False),
        (output(MISSING, 'Traceback'), False),
        (Difference('rate of messages', '/t', '10 Hz', '5 Hz'), True),
        (Difference('node', '/b', MISSING, 'there'), False),
        (Difference('messages', '/t', 'none', '4'), False),
        (Difference('parameter', 'n of /a', '1', '2'), False),
        (Difference('exit code', 'a', '0', '1'), False),
    ],
)
def test_what_only_says_how_fast_somebody_is_informs(difference: Difference, expected: bool) -> None:
    assert informs(difference, seen(10.0), seen(20.0), 0.0) is expected


@pytest.mark.parametrize(
    ('first_s', 'late_s', 'expected'), [(7.0, 0.0, False), (8.0, 0.0, True), (1.0, 12.0, False), (1.0, 14.0, True)]
)
def test_what_the_real_run_lacks_decides_once_it_is_overdue(first_s: float, late_s: float, expected: bool) -> None:
    """After twice the time of the simulation, 5 s, and what the programs needed to come up."""
    here = seen(
        10.0,
        nodes={'/b': first_s},
        lines=[Line('a', 'done', first_s)],
        flows={'/t': Flow([first_s], {})},
        programs={'a-1': Program(0.0, first_s, 0)},
    )
    for lacking in (
        Difference('node', '/b', 'there', MISSING),
        output('done', MISSING),
        Difference('messages', '/t', '1', 'none'),
        Difference('exit code', 'a', '0', 'still running'),
    ):
        assert informs(lacking, here, seen(20.0), late_s) is expected, lacking


def test_a_line_that_its_program_has_gone_past_decides_at_once() -> None:
    said = [*(Line('a', 'tick', float(second)) for second in range(9)), Line('a', 'done', 9.5)]
    ticks = [Line('a', 'tick', float(second)) for second in range(12)]
    lacking = output('done', MISSING)
    assert informs(lacking, seen(10.0, lines=said), seen(12.0, lines=ticks[:8]), 0.0)
    assert not informs(lacking, seen(10.0, lines=said), seen(12.0, lines=ticks), 0.0)
    assert not informs(lacking, seen(10.0, lines=[*said, Line('a', 'bye', 9.8)]), seen(12.0, lines=[Line('a', 'bye', 4.0)]), 0.0)


def test_values_that_the_real_run_lacks_decide_after_as_many_messages() -> None:
    here = seen(10.0, flows={'/t': Flow([float(second) for second in range(10)], {}), 'tf a -> b': Flow([1.0, 2.0], {})})
    lacking = Difference('values in messages', '/t x', '0 to 9', '0 to 5', lacks=True)
    for count, expected in ((6, True), (10, False)):
        assert informs(lacking, here, seen(20.0, flows={'/t': Flow([1.0] * count, {})}), 0.0) is expected
    turned = Difference('transform', 'a -> b transform.rotation.z', '0 to 1', '0', lacks=True)
    assert informs(turned, here, seen(20.0, flows={'tf a -> b': Flow([1.0], {})}), 0.0)
    assert not informs(turned, here, seen(20.0, flows={'tf a -> b': Flow([1.0, 2.0], {})}), 0.0)

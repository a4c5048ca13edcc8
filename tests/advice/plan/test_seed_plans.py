"""Plans of all seed launch files agree with those that the original launch made."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from edulaunch.advice.plan import rehearse
from edulaunch.engine.packages import Index
from edulaunch.ros.sources import read_source
from tests.advice.plan.conftest import FILES, SEEDS, TOOLS, seed_rows

PLANS = [(row, entry) for row, entry in seed_rows() if entry['outcome'] == 'plan']


@pytest.mark.parametrize(('row', 'entry'), PLANS, ids=[entry['plan'][6:-5] for _, entry in PLANS])
def test_the_plan_is_that_of_the_original_launch(row: Any, entry: Any, places: Any) -> None:
    expected = json.loads((SEEDS / entry['plan']).read_text(encoding='utf-8'))
    index = places.index(row['file'])
    plan = rehearse(FILES / row['file'], entry['args'], index, places.environ(), assume_packages=True, command_set=TOOLS).plan
    assert places.normalised(plan, index) == expected


def strict_rows() -> list[Any]:
    """Rows with the outcome on a machine without placeholders; our underlay has two more packages."""
    rows = []
    for row, entry in seed_rows():
        error = entry['strict'].get('error')
        if error is not None and any(name in error for name in ('turtlebot3_gazebo', 'tuos_simulations')):
            error = None
        rows.append(pytest.param(row['file'], entry['args'], error, id='-'.join((row['file'], *entry['args']))))
    return rows


def without_places(text: str) -> str:
    """An error text without what differs from machine to machine."""
    text = re.sub(r'searching: \[.*?\]', 'searching: @PATHS', text)
    text = re.sub(r'\([^()]*/launch/actions/__init__\.py\)', '(@ACTIONS)', text)
    text = re.sub(r'0x[0-9a-f]*', '0x', text.replace(str(FILES), '@FILES'))
    return re.sub(r"'[^' ]*/lib/", "'@PREFIX/lib/", text)


@pytest.mark.parametrize(('file', 'args', 'error'), strict_rows())
def test_without_placeholders_the_outcome_is_that_of_a_real_machine(file: str, args: list[str], error: str | None) -> None:
    plan = rehearse(
        FILES / file, args, Index([], [FILES], read_source=read_source), {'USER': 'student', 'PATH': '/usr/bin:/bin'}
    ).plan
    found = plan['error'] and f'{plan["error"]["type"]}: {plan["error"]["text"]}'
    assert (found and without_places(found)) == (error and without_places(error))

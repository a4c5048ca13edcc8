"""Submissions of kinds that the other attacks do not have, in one class with an honest one, as root and without any right."""

from __future__ import annotations

import csv
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests.attacks.kinds import PYTHON, TEXTS
from tests.attacks.legal import RADIUS
from tests.attacks.test_reach import CIRCLE, command
from tests.attacks.test_reach import pytestmark as on_this_system

pytestmark = on_this_system
HONEST_REST = 5
WHO = ['as we are', 'as somebody without any right']


@pytest.fixture(scope='module', params=WHO)
def marks(request: pytest.FixtureRequest) -> dict[str, dict[str, str]]:
    """The row of each student."""
    start, environment = command(request.param)
    solution = CIRCLE.read_text()
    rest = solution.replace(RADIUS, '')
    texts = {'honest': ('py', solution), 'rest': ('py', rest)}
    texts |= {name: ('py', f'{rest}\n\n{code}') for name, code in PYTHON.items()} | TEXTS
    with TemporaryDirectory(prefix='edulaunch-kinds-') as place:
        Path(place).chmod(0o755)
        (Path(place) / 'out').mkdir()
        (Path(place) / 'out').chmod(0o777)
        for name, (ending, text) in texts.items():
            (Path(place) / 'class' / name).mkdir(parents=True)
            (Path(place) / 'class' / name / f'circle.launch.{ending}').write_text(text)
        words = ['batch', f'{place}/class', '--csv', f'{place}/out/marks.csv', '--out', f'{place}/out/results', '--seed', '7']
        for again in ([], ['--resume'], ['--resume']):  # what a busy computer cut off has no mark, and is graded again
            done = subprocess.run([*start, *words, *again], env=environment, cwd='/', capture_output=True, text=True)
            assert (Path(place) / 'out' / 'marks.csv').exists(), done.stdout + done.stderr
            with open(Path(place) / 'out' / 'marks.csv', newline='') as file:
                rows = {row['student']: row for row in csv.DictReader(file)}
            if all(row['earned'] for row in rows.values()):
                break
        return rows


@pytest.mark.parametrize('name', [*PYTHON, *TEXTS])
def test_it_gains_nothing_and_gets_a_mark(marks: dict[str, dict[str, str]], name: str) -> None:
    row = '; '.join(marks[name].values())  # as one text, because pytest shortens a dictionary
    assert marks[name]['earned'] != '', row
    assert float(marks[name]['earned']) <= HONEST_REST, row


def test_the_others_get_what_they_deserve(marks: dict[str, dict[str, str]]) -> None:
    assert (marks['honest']['earned'], marks['rest']['earned']) == ('12', str(HONEST_REST)), marks['honest']
    values = 'values that the trusted peer keeps for itself'
    assert marks[values]['earned'] == str(HONEST_REST), marks[values]  # its own assertion holds


def test_too_many_programs_are_named_so(marks: dict[str, dict[str, str]]) -> None:
    assert 'too many programs' in ' '.join(marks['too many programs'].values())

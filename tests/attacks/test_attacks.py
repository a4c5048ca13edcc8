"""A class of hostile submissions, graded in two batches beside honest ones: nobody gains a point, harms a neighbour, or stays behind.

Run by `pytest tests/attacks` and as a step of `.ci/run`, not with the unit tests: it takes a minute.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.attacks.legal import LEGAL, RADIUS
from tests.attacks.payloads import LOUD, SOFT, quiet

pytestmark = pytest.mark.attacks
ROOT = Path(__file__).resolve().parents[2]
CIRCLE = (ROOT / 'solutions' / 'circle.launch.py').read_text()
LAZY = CIRCLE.replace(RADIUS, '')
DESERVED = 5
"""Points of the circle whose node is not told the radius."""
ALL = 12
HONEST = [f'{place}-honest' for place in ('a', 'k-middle', 'r-middle', 'z')]
LIMIT_S = 3600  # a busy machine takes its time; nothing is measured by it


def submissions() -> dict[str, str]:
    """Every hostile file by the student's name."""
    found = {f'h-{name}': LAZY + text.replace('{root}', str(ROOT)) for name, text in LOUD.items()}
    found |= {f'h-{name}': LAZY + quiet(text.replace('{root}', str(ROOT))) for name, text in SOFT.items()}
    for name, changes in LEGAL.items():
        text = CIRCLE
        for old, new in changes:
            assert text.count(old) == 1, name
            text = text.replace(old, new)
        found[f'l-{name}'] = text
    return found


def test_there_are_a_hundred() -> None:
    assert len(submissions()) >= 120


def is_shown(name: str) -> bool:
    """Whether the student's report gets a page as well: where something is said, or recorded that is not from the circle. The pages of all
    others show the same circle once more, and drawing takes longer than grading.
    """
    text = (LOUD | SOFT).get(name.removeprefix('h-'), '')
    return not name.startswith('h-') or any(word in text for word in ('print(', 'raise ', 'write(1,', 'write(2,'))


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The results by student, of two batches with two jobs each: with pages and without; honest ones are in both."""
    folder = tmp_path_factory.mktemp('class')
    found = submissions()
    shown = {name: text for name, text in found.items() if is_shown(name)}
    results = _batch(folder / 'silent', {name: text for name, text in found.items() if name not in shown})
    for name in HONEST:
        results[f'{name} without a page'] = results.pop(name)
    return {**results, **_batch(folder / 'shown', shown, '--html', str(folder / 'html')), 'folder': folder}


def _batch(folder: Path, texts: dict[str, str], *more: str) -> dict[str, Any]:
    """Grade files beside honest ones; returns the results by student."""
    handed_in = folder / 'submissions'
    for name, text in (texts | dict.fromkeys(HONEST, CIRCLE)).items():
        (handed_in / name).mkdir(parents=True)
        (handed_in / name / 'circle.launch.py').write_text(text)
    before = {path: path.stat().st_mtime_ns for path in (ROOT / 'grader').rglob('*.py')}
    words = ['batch', str(handed_in), '--out', str(folder / 'results'), '--jobs', '2', '--seed', '7', *more]
    done = subprocess.run([sys.executable, '-m', 'edugrade', *words], capture_output=True, text=True, timeout=LIMIT_S, cwd=folder)
    assert done.returncode in (0, 1), done.stderr[-2000:]
    assert before == {path: path.stat().st_mtime_ns for path in (ROOT / 'grader').rglob('*.py')}
    assert {name: (handed_in / name / 'circle.launch.py').read_text() for name in HONEST} == dict.fromkeys(HONEST, CIRCLE)
    documents = (json.loads(path.read_text()) for path in sorted((folder / 'results').glob('**/*.json')))
    return {found['student']: found for found in documents if isinstance(found, dict) and 'student' in found}


def earned(graded: dict[str, Any], name: str) -> Any:
    """The points of a student."""
    return graded[name]['points']['earned']


@pytest.mark.parametrize('name', sorted(submissions()))
def test_nobody_gains_a_point(graded: dict[str, Any], name: str) -> None:
    points = earned(graded, name)
    assert points is not None, 'a zero at worst, never "the grader broke"'
    assert points <= (DESERVED if name.startswith('h-') else ALL - 1), name


@pytest.mark.parametrize('name', [*HONEST, *(f'{name} without a page' for name in HONEST)])
def test_the_honest_ones_get_all_points(graded: dict[str, Any], name: str) -> None:
    assert earned(graded, name) == ALL


def test_nothing_stays_behind(graded: dict[str, Any]) -> None:
    left = subprocess.run(['ps', '-eo', 'pid,ppid,args'], capture_output=True, text=True).stdout
    assert str(graded['folder']) not in left
    assert 'sleep 600' not in left
    assert not os.path.exists('/tmp/edulaunch-attack')


def test_pages_hold_no_markup_and_no_control_characters(graded: dict[str, Any]) -> None:
    pages = list((graded['folder'] / 'html').rglob('*.html'))
    assert len(pages) >= 30
    assert any('&lt;script&gt;alert(1)' in page.read_text() for page in pages)
    for page in pages:
        text = page.read_text()
        assert '<script>alert(1)</script>' not in text and '\x1b' not in text and '\x00' not in text, page

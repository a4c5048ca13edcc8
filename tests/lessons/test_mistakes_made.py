"""Twenty things or more that a beginner does wrong in each lesson, really done: something is said, and it is of use."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.lessons.student import Student

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(__file__).parent / 'mistakes'
TABLES = {path.stem: tomllib.loads(path.read_text('utf-8'))['mistake'] for path in sorted(FOLDER.glob('*.toml'))}
MADE = [pytest.param(lesson, made, id=f'{lesson}: {made["title"]}') for lesson, rows in TABLES.items() for made in rows]
OURS = re.compile(r'File ".*/edulaunch/(?!ros)|at 0x[0-9a-f]{4,}')


@pytest.mark.whole
@pytest.mark.filterwarnings('ignore:The parameter .period. must be a float')
@pytest.mark.parametrize(('lesson', 'made'), MADE)
def test_a_mistake_is_answered(lesson: str, made: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('USER', 'student')
    told = Student(lesson, tmp_path).walk(made['cells'], made.get('edits', {}))
    assert ' '.join(made['told'].split()) in ' '.join(told.split()), told  # a report wraps its lines
    assert lesson == '00_python' or not OURS.search(told), told  # that lesson shows what Python itself says


@pytest.mark.parametrize('lesson', TABLES)
def test_twenty_mistakes_are_made_in_each_lesson(lesson: str) -> None:
    titles = [made['title'] for made in TABLES[lesson]]
    assert len(titles) >= 20 and len(set(titles)) == len(titles)

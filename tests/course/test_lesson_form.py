"""`edulaunch course lint` names what is wrong with a lesson, by file and cell."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.course.copying import new_course
from edulaunch.course.lesson_form import lesson_problems
from tests.house import ROOT


def cells(change: Callable[[list[dict[str, Any]]], object]) -> Callable[[Path], object]:
    """A mistake made in the cells of the lesson."""

    def made(lessons: Path) -> None:
        path = lessons / '01_circle.ipynb'
        raw = json.loads(path.read_text())
        change(raw['cells'])
        path.write_text(json.dumps(raw))

    return made


def questions(old: str, new: str) -> Callable[[Path], object]:
    """A mistake made in the questions."""

    def change(lessons: Path) -> None:
        file = lessons.parent / 'solutions' / 'questions.toml'
        file.write_text(file.read_text().replace(old, new))

    return change


OUTPUT = {'output_type': 'stream', 'name': 'stdout', 'text': 'x'}
MISTAKES = {
    'lessons/01_circle.ipynb: it has outputs, which students would get (first in the cell set-up)': cells(
        lambda all: all[1].update(outputs=[OUTPUT])
    ),
    'lessons/01_circle.ipynb: it does not begin with a heading': cells(lambda all: all.pop(0)),
    'lessons/01_circle.ipynb: the cell id "title" appears 2 times': cells(lambda all: all.append(all[0])),
    'lessons/01_circle.ipynb: the cell id "3f2A" must consist of words': cells(lambda all: all[0].update(id='3f2A')),
    'lessons/01_circle.ipynb: the cell new has no stored outputs': cells(lambda all: all.append({**all[1], 'id': 'new'})),
    'lessons/01_circle.ipynb: the outputs of a missing cell set-up are stored': cells(lambda all: all.pop(1)),
    'lessons/01_circle.ipynb is not a notebook: cell 2 has a "cell_type" that is not one of': cells(
        lambda all: all[1].pop('cell_type')
    ),
    'lessons/01_circle.ipynb is not a notebook: cell 2 has an "id" that is not a string': cells(lambda all: all[1].update(id=7)),
    'lessons/01_circle.ipynb is not a notebook: cell ': cells(lambda all: all.append(7)),
    'lessons/01_circle.ipynb is not a notebook: it is not JSON': lambda lessons: (lessons / '01_circle.ipynb').write_text('{'),
    'lessons/01_circle.ipynb: cannot read the outputs of': lambda lessons: (lessons / '.outputs' / '01_circle.json').unlink(),
    'lessons/conftest.py is missing': lambda lessons: (lessons / 'conftest.py').unlink(),
    'solutions/questions.toml has no question "radius-of-circle", which a lesson uses': questions('radius-of-circle', 'radius'),
    'solutions/questions.toml: the question "radius-of-circle" names the lesson 09_none': questions('01_circle', '09_none'),
    'solutions/questions.toml has no explanation "why", which a lesson uses': cells(
        lambda all: all[1].update(source="explain('why', ...)")
    ),
    'cannot read the questions in': questions("right = 'c'", 'right = '),
}


@pytest.mark.parametrize('told', MISTAKES)
def test_a_mistake_is_named(told: str, tmp_path: Path) -> None:
    new_course(str(tmp_path))
    assert list(lesson_problems(str(tmp_path))) == []
    MISTAKES[told](tmp_path / 'lessons')
    assert [problem for problem in lesson_problems(str(tmp_path)) if problem.startswith(told)]


def test_our_own_lessons_have_the_form() -> None:
    assert list(lesson_problems(str(ROOT))) == []

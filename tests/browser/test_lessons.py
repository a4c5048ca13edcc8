"""JupyterLab shows each lesson, runs it, and asks nobody else for anything."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from edulaunch.course.questions import FILE, read_questions
from tests.browser.lab import WANTED, Lab
from tests.browser.student import BrowserStudent
from tests.lessons.notebook import LESSONS, ORDER, Lesson

pytestmark = pytest.mark.browser

QUESTIONS = read_questions(str(LESSONS.parent / 'solutions' / FILE))


@pytest.mark.parametrize('name', ORDER)
def test_a_student_goes_through_a_lesson(lab: Lab, course: Path, name: str) -> None:
    """Guesses typed, cells completed wrongly and rightly, questions answered, the desk driven; then looked at from top to bottom."""
    stored = Lesson(name)
    with lab.open(name) as page:
        student = BrowserStudent(page, stored, course, QUESTIONS)
        student.go_through()
        assert page.requests == []
        assert student.done
        texts = page.page.locator('.jp-OutputArea img').evaluate_all('images => images.map(image => image.alt)')
        assert all(len(text) > 10 for text in texts), texts
        for number, cell in enumerate(cell for cell in stored.cells if cell.kind == 'markdown'):
            if WANTED and (cell.source.startswith('## ') or number == 0):
                page.show(cell.id, f'{number:02}-{cell.id}')


EARLY = """() => {
  const cells = window.jupyterapp.shell.currentWidget.content.widgets.filter(cell => cell.model.type === 'code');
  const picture = cells.find(cell => cell.model.id === 'multisim-picture').model, last = cells[cells.length - 1].model;
  picture.outputs.changed.connect(() => { if (picture.outputs.length) window.isEarly ??= last.executionCount === null; });
}"""


def test_a_lesson_that_runs_all_at_once(lab: Lab, solved: None) -> None:
    """A picture comes while later cells are still to run, the slider of a replay moves the turtle, and what is solved passes."""
    with lab.open('01_first_launch') as page:
        page.page.evaluate(EARLY)
        page.run_all()
        assert page.page.evaluate('window.isEarly')
        page.show('check', 'check-passed')
        assert 'all passed, 12 of 12 points' in json.dumps(page.cells()['check']['outputs'])
        page.show('square-picture')
        player = page.page.frame_locator('.jp-OutputArea iframe')
        picture = player.locator('.worlds canvas').first
        picture.wait_for()
        before = picture.get_attribute('aria-label')
        slider = player.get_by_label('time in the run')
        slider.evaluate('slider => { slider.value = slider.max; slider.dispatchEvent(new Event("input")); }')
        player.locator('.clock').filter(has_text='20.000 s').wait_for()
        after = picture.get_attribute('aria-label')
        page.show('square-picture', 'replay-at-the-end')
    assert 'turtle1 at (5.54, 5.54)' in before
    assert re.search(r'20\.00 seconds: turtle1 at \(5\.53, 5\.5[56]\)', after), after


@pytest.fixture
def solved(course: Path) -> Iterator[None]:
    """The circle is solved, and afterwards as it was."""
    file = course / 'exercises' / 'circle.launch.py'
    before = file.read_bytes()
    shutil.copy(course / 'solutions' / 'circle.launch.py', file)
    yield
    file.write_bytes(before)

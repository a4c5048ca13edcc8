"""Each lesson has notes for teachers, and their time plan is about the lesson as it is."""

from __future__ import annotations

import re

import pytest

from edulaunch.course.lessons import read_notes, time_plan
from tests.house import ROOT
from tests.lessons.doing import stated_minutes
from tests.lessons.notebook import ORDER, Lesson

NOTES = read_notes(str(ROOT))
PARTS = ('Time', 'What students say, and what to ask', 'On the board', 'When something fails', 'Hints and exercises')


def headings(lesson: Lesson) -> list[str]:
    return re.findall(r'^## (.*)', lesson.prose, re.M)


def test_every_lesson_has_notes_and_no_notes_are_left_over() -> None:
    assert list(NOTES) == ORDER


@pytest.mark.parametrize('name', ORDER)
def test_the_time_plan_names_the_sections_of_the_lesson(name: str) -> None:
    lesson, planned = Lesson(name), [section for _, section in time_plan(NOTES[name])]
    there = [heading for heading in headings(lesson) if heading[0].isdigit()]
    gone = [section for section in planned if section not in there]
    assert gone == [], f'lessons/notes/{name}.md plans time for what the lesson has not; it has {there}'
    missing = [heading for heading in there if heading not in planned]
    assert missing == [], f'lessons/notes/{name}.md plans no time for this'


@pytest.mark.parametrize('name', ORDER)
def test_the_time_plan_takes_as_long_as_the_lesson_says(name: str) -> None:
    planned, stated = sum(minutes for minutes, _ in time_plan(NOTES[name])), stated_minutes(Lesson(name))
    assert abs(planned - stated) <= 5, f'lessons/notes/{name}.md plans {planned} minutes, the lesson says {stated}'


@pytest.mark.parametrize('name', ORDER)
def test_notes_have_what_a_teacher_looks_for(name: str) -> None:
    text = NOTES[name]
    parts = re.findall(r'^## (.*)', text, re.M)
    assert [part for part in PARTS if part not in parts] == []
    assert '**To take home:**' in text and '**45 minutes:**' in text and '**90 minutes:**' in text
    assert text.count('\n- **"') >= 7, 'what students say, in their words'
    assert 50 <= text.count('\n') <= 100


@pytest.mark.parametrize('name', ORDER)
def test_notes_speak_of_the_exercises_of_the_lesson(name: str) -> None:
    from edugrade.course import read_course

    text = NOTES[name]
    ours = [exercise.name for exercise in read_course(str(ROOT / 'exercises' / 'course.toml')) if exercise.lesson == name]
    assert [exercise for exercise in ours if f'`{exercise}`' not in text] == []


@pytest.mark.parametrize('name', ORDER)
def test_sections_that_notes_point_to_are_there(name: str) -> None:
    numbers = {heading.split()[0] for each in ORDER for heading in headings(Lesson(each)) if heading[0].isdigit()}
    own = str(int(name[:2]))
    named = set(re.findall(rf'(?<![\d./-]){own}\.\d+(?![\d/])', NOTES[name]))
    assert sorted(named - numbers) == []

"""Lessons run apart, several at once, and only once while nothing changes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from edulaunch.course import runs
from edulaunch.course.runs import run_lessons
from edulaunch.errors import UnusableInput


def notebook(folder: Path, name: str, *sources: str) -> None:
    cells = [
        {'cell_type': 'code', 'id': f'c{number}', 'metadata': {}, 'source': source, 'outputs': [], 'execution_count': None}
        for number, source in enumerate(sources)
    ]
    raw = {'cells': cells, 'metadata': {'kernelspec': {'name': 'python3'}}, 'nbformat': 4, 'nbformat_minor': 5}
    (folder / f'{name}.ipynb').write_text(json.dumps(raw))


PRINTED = {'output_type': 'stream', 'name': 'stdout'}


@pytest.fixture
def course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A course of two lessons; a run is recorded and gives the files of its folder in place of outputs."""
    monkeypatch.setenv('XDG_CACHE_HOME', str(tmp_path / 'cache'))
    folder = tmp_path / 'course' / 'lessons'
    folder.mkdir(parents=True)
    notebook(folder, '01_one', '%%writefile my_launch/a.py\nx = 1', '%%writefile my_launch/a.py\nx = 2')
    notebook(folder, '02_two', 'print(1)')
    return tmp_path / 'course'


@pytest.fixture
def ran(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, dict[str, str]]]:
    seen: list[tuple[str, dict[str, str]]] = []

    def run(path: str, called: str) -> object:
        assert called == f'lessons/{Path(path).name}', 'a message names the lesson, and not the folder in which it runs'
        here = Path(path).parent
        seen.append((Path(path).stem, {file.name: file.read_text() for file in here.rglob('my_launch/*')}))
        return {'cells': [{'cell_type': 'code', 'id': 'c0', 'outputs': [{**PRINTED, 'text': f'in {here}/my_launch'}]}]}

    monkeypatch.setattr(runs, 'run_notebook', run)
    return seen


def test_a_lesson_runs_alone_with_the_files_that_earlier_ones_write(course: Path, ran: list[tuple[str, dict[str, str]]]) -> None:
    said: list[str] = []
    gave = run_lessons(str(course), ['01_one', '02_two'], ['02_two'], said.append)
    assert ran == [('02_two', {'a.py': 'x = 2\n'})]
    assert gave == {'02_two': {'c0': [{**PRINTED, 'text': 'in my_launch'}]}} and said == [
        'running 1 lesson',
        '02_two: lesson 1 of 1',
    ]


def test_nothing_runs_again_until_something_changes(course: Path, ran: list[tuple[str, dict[str, str]]]) -> None:
    both = ['01_one', '02_two']
    first, said = run_lessons(str(course), both, both), []
    assert run_lessons(str(course), both, both, said.append) == first and len(ran) == 2
    assert said == ['2 of 2 lessons have not changed since their last run']
    notebook(course / 'lessons', '02_two', 'print(2)')
    run_lessons(str(course), both, both)
    assert [name for name, _ in ran[2:]] == ['02_two']
    notebook(course / 'lessons', '01_one', 'print(3)')
    run_lessons(str(course), both, both)
    assert sorted(name for name, _ in ran[3:]) == both, 'a later lesson depends on an earlier one'


def test_a_lesson_that_needs_more_makes_all_run_in_order(course: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ran: list[str] = []

    def run(path: str, called: str) -> object:
        assert called == f'lessons/{Path(path).name}', 'a message names the lesson, and not the folder in which it runs'
        here = Path(path).parent
        if here.joinpath('my_made').exists() < Path(path).stem.startswith('02'):
            raise UnusableInput('a cell failed')
        here.joinpath('my_made').touch()
        ran.append(Path(path).stem)
        return {'cells': []}

    monkeypatch.setattr(runs, 'run_notebook', run)
    said: list[str] = []
    assert set(run_lessons(str(course), ['01_one', '02_two'], ['01_one', '02_two'], said.append)) == {'01_one', '02_two'}
    assert ran[-2:] == ['01_one', '02_two'] and any('in order' in line for line in said)


def test_a_file_outside_of_the_lesson_is_not_written(course: Path, ran: list[tuple[str, dict[str, str]]]) -> None:
    notebook(course / 'lessons', '01_one', '%%writefile ../../escape.py\nx', '%%writefile /tmp/escape.py\nx')
    run_lessons(str(course), ['01_one', '02_two'], ['02_two'])
    assert ran == [('02_two', {})]

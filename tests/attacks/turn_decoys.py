"""Decoys of the lessons' turns: each turn is solved as its hints say, and then graded with the behaviour taken away.

    python -m tests.attacks.turn_decoys LESSON CELL TURN FOLDER

A turn is graded where the student works, so a decoy can change the process. Each turn and each decoy has a process of its own.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from edugrade.decoys.command import Paid
from edugrade.decoys.maker import decoys, plan
from edugrade.decoys.player import PLAYER
from edugrade.results import PASSED, Report
from edugrade.rubric import Rubric
from edugrade.rubrics.catalogue import load_rubric
from edugrade.submission import Submission
from edugrade.turn import grade_turn
from edugrade.worker import in_worker

from edulaunch.desk.notebook.terminal import CellTerminal
from edulaunch.runtime.session import Session
from tests.attacks.turn_answers import MORE
from tests.browser.answers import ANSWERS
from tests.lessons.notebook import LESSONS, Lesson, Walk, _chdir
from tests.lessons.test_your_turn import CALL

XML = '<launch>{arguments}<executable cmd="python3 {program}{known}"/></launch>\n'


def turns_of(lesson: str) -> list[tuple[str, str]]:
    """Return (cell, turn) of each check of a lesson, in their order."""
    return [(cell.id, name) for cell in Lesson(lesson).code for name in CALL.findall(cell.source)]


def solve(lesson: str, cell: str, folder: Path) -> Walk:
    """Write the files of a lesson up to a check as a student does who has understood it."""
    for part in ('checkpoints', 'checks'):
        shutil.copytree(LESSONS / part, folder / part)
    student = Walk(Lesson(lesson), folder)
    answers = {**ANSWERS, **MORE}
    for each in student.lesson.code:
        if each.file is not None or each.id in ('set-up', 'folders', 'comprehension'):
            student.run(each.id)
        for path, old, new in answers.get((lesson, each.id), []):
            _write(student, path, old, new)
        if each.id == cell:
            return student
    raise AssertionError(f'{lesson} has no cell {cell}')


def _write(student: Walk, path: str, old: str, new: str) -> None:
    if path == 'ros2':
        with _chdir(student.folder):
            CellTerminal(lambda stream, text: None).ros2(new)
    elif path == 'bag':
        with _chdir(student.folder), Session() as session:
            session.launch(new)
            session.run(10.0)
            session.interrupt()
            session.run(2.0)
    elif '.' not in os.path.basename(path):  # a cell that writes no file
        source = CALL.sub('', student.lesson[path].source.replace(old, new)) if old else new
        exec(source, student.names)
    elif old:
        student.edit(path, old, new)
    else:
        student.write(path, new)


def graded(name: str, folder: Path, names: Mapping[str, Any]) -> Report:
    """Grade a turn where the student works."""
    with _chdir(folder):
        return grade_turn(name, str(Path('checks') / rubric_file(name).name), names)


def rubric_file(name: str) -> Path:
    """The rubric of a turn."""
    return next(path for path in sorted((LESSONS / 'checks').glob(f'{name}.*')) if path.suffix in ('.py', '.yaml'))


def pay_turn(name: str, student: Walk, place: Path) -> Iterator[Paid]:
    """Yield what each decoy of a solved turn gets."""
    rubric = load_rubric(str(rubric_file(name)))
    solved = graded(name, student.folder, student.names)
    assert solved.earned == solved.possible, [(result.sentence, result.reason, result.seen) for result in solved.results]
    if rubric.names:
        return  # it compares a value that a cell computed, and runs nothing
    recording = solved.outcomes[0].recording
    assert recording is not None
    made = _of_program if rubric.launch else _of_launch_file
    for kind, folder in made(rubric, student.folder, recording, place):
        earned, possible, passed = in_worker(partial(_paid, name, folder, student.names))  # it may change what it runs in
        yield Paid(name, kind, earned, possible, tuple(passed), rubric.decoys)


def _paid(name: str, folder: Path, names: Mapping[str, Any]) -> tuple[float | None, int, list[str]]:
    report = graded(name, folder, names)
    return (
        report.earned,
        report.possible,
        [result.name for result in report.results if result.status == PASSED and result.points],
    )


def _of_program(rubric: Rubric, source: Path, recording: Any, place: Path) -> Iterator[tuple[str, Path]]:
    """A program of the student's, which the rubric starts: one that plays what was recorded of it."""
    own = frozenset(process.name for process in recording.processes if any(rubric.of in word for word in process.argv))
    assert own, [process.argv for process in recording.processes]
    for kind, plays in (('names', False), ('replay', True)):
        folder = _copied(source, place / kind)
        (folder / rubric.of).write_text(PLAYER.format(plan=json.dumps(plan(recording, plays, own))))
        yield kind, folder


def _of_launch_file(rubric: Rubric, source: Path, recording: Any, place: Path) -> Iterator[tuple[str, Path]]:
    with _chdir(source):
        made = list(decoys(Submission(rubric.of), recording, str(place / 'made')))
    for kind, path in made:
        folder = _copied(source, place / kind.replace(' ', '_'))
        if kind == 'own programs':
            shutil.copytree(path, folder / _package(rubric.of), dirs_exist_ok=True)
        elif kind == 'swapped':
            inner = Path(path) / Path(rubric.of).relative_to(_package(rubric.of)) if os.path.isdir(path) else Path(path)
            shutil.copy(inner, folder / rubric.of)
        elif rubric.of.endswith('.xml'):
            _write_xml(folder, rubric.of, Path(path).read_text())
        else:
            shutil.copy(path, folder / rubric.of)
        yield kind, folder


def _write_xml(folder: Path, target: str, text: str) -> None:
    """The same decoy as an XML file, which starts its program."""
    names: dict[str, Any] = {}
    exec('\n'.join(line for line in text.splitlines() if line.startswith(('ARGUMENTS =', 'TEXT ='))), names)
    program = folder / 'decoy.py'
    program.write_text(names['TEXT'])
    arguments = ''.join(f'<arg name="{name}" default="{value}"/>' for name, value in names['ARGUMENTS'].items())
    known = ''.join(f' known_{name}:=$(var {name})' for name in names['ARGUMENTS'])
    (folder / target).write_text(XML.format(arguments=arguments, program=program, known=known))


def _package(path: str) -> str:
    """Return the folder of the package that has a file: my_ws/src/NAME."""
    return '/'.join(path.split('/')[:3])


def _copied(source: Path, target: Path) -> Path:
    shutil.copytree(source, target)
    return target


def main(lesson: str, cell: str, name: str, folder: str) -> None:
    """Print one line of JSON for each decoy of a turn."""
    os.environ['USER'] = 'student'
    student = Path(folder) / 'student'
    student.mkdir()
    for one in pay_turn(name, solve(lesson, cell, student), Path(folder) / 'decoys'):
        print(json.dumps(one))


if __name__ == '__main__':
    main(*sys.argv[1:])

"""A class is graded one result at a time: none is lost, none is done twice, none costs another its mark."""

from __future__ import annotations

import csv
import io
import itertools
import json
import os
import shutil
import signal
from pathlib import Path
from typing import Any, NoReturn

import pytest
from edugrade.batch import Class, Entry
from edugrade.class_tables import class_csv, class_page
from edugrade.cli import main
from edugrade.grading import Work

SOLUTIONS = Path(__file__).parents[2] / 'solutions'
STUDENTS = ('anna', 'bert', 'carl', 'dora')


@pytest.fixture
def group(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Four right answers, a hostile one, a pipe, and a link to somebody else's; the private folders are beside them."""
    folder = tmp_path / 'class'
    text = (SOLUTIONS / 'static_frame.launch.py').read_text()
    for name in STUDENTS:
        (folder / name).mkdir(parents=True)
        (folder / name / 'static_frame.launch.py').write_text(f'{text}# {name}\n')
    (folder / 'mallory').mkdir()
    (folder / 'mallory' / 'static_frame.launch.py').write_text('import posix\nposix.kill(posix.getpid(), 9)\n')
    (folder / 'mallory' / 'link').symlink_to(folder / 'anna')
    (folder / 'peter').mkdir()
    os.mkfifo(folder / 'peter' / 'static_frame.launch.py')
    (tmp_path / 'private').mkdir()
    monkeypatch.setenv('TMPDIR', str(tmp_path / 'private'))
    return folder


def results(folder: Path) -> dict[str, Any]:
    out = Path(f'{folder}.results')
    return {str(path.relative_to(out)): path.read_bytes() for path in sorted(out.rglob('*.json'))}


def killed_after(number: int, group: Path, monkeypatch: pytest.MonkeyPatch) -> NoReturn:
    """Be a grader that is killed when it has written this many results and begins the next one."""
    made = itertools.count()
    save = Class.save

    def last(self: Class, entry: Entry, work: Work | None, content: dict[str, Any]) -> None:
        if next(made) > number:
            os.kill(os.getpid(), signal.SIGKILL)
        save(self, entry, work, content)

    monkeypatch.setattr(Class, 'save', last)
    main(['batch', str(group), '--resume'])
    os._exit(9)


def test_each_submission_has_its_result_and_a_line_in_the_table(group: Path, tmp_path: Path) -> None:
    assert main(['batch', str(group), '--csv', str(tmp_path / 'marks.csv'), '--html', str(tmp_path / 'pages')]) == 0
    rows = list(csv.DictReader(io.StringIO((tmp_path / 'marks.csv').read_text())))
    assert [(row['student'], row['earned']) for row in rows] == [
        *((name, '12') for name in STUDENTS),
        ('mallory', '0'),
        ('peter', ''),
    ]
    assert rows[4]['first_problem'] == 'the program was ended by SIGKILL before the run was over'
    assert 'regular file' in rows[5]['first_problem']
    page = (tmp_path / 'pages' / 'index.html').read_text()
    assert 'href="anna/static_frame.launch.py.html"' in page
    assert (tmp_path / 'pages' / 'anna' / 'static_frame.launch.py.html').read_text().count('<section') == 1
    assert os.listdir(tmp_path / 'private') == []


def test_a_killed_grader_goes_on_where_it_was(group: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert main(['batch', str(group)]) == 0
    whole = results(group)
    shutil.rmtree(f'{group}.results')
    saved: list[str] = []
    save = Class.save

    def counted(self: Class, entry: Entry, work: Work | None, content: dict[str, Any]) -> None:
        save(self, entry, work, content)
        saved.append(entry.student)

    monkeypatch.setattr(Class, 'save', counted)
    for number in (1, 2):  # killed after that many of the results still to be made
        pid = os.fork()
        if pid == 0:
            killed_after(number, group, monkeypatch)
        assert os.waitpid(pid, 0)[1] == signal.SIGKILL
    before = set(results(group))
    assert 2 <= len(before) < len(whole)
    assert main(['batch', str(group), '--resume']) == 0
    assert results(group) == whole
    assert not {f'{name}/static_frame.launch.py.json' for name in saved if name != 'peter'} & before


def test_an_edit_is_graded_again_and_the_rest_is_kept(group: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(['batch', str(group)])
    (group / 'anna' / 'static_frame.launch.py').write_text('x = 1\n')
    main(['batch', str(group), '--resume'])
    assert '6 submissions, 4 of them from before; 5 have a mark.' in capsys.readouterr().out
    found = json.loads(results(group)['anna/static_frame.launch.py.json'])
    assert (found['student'], found['points']['earned']) == ('anna', 0)


def test_half_a_result_is_no_result(group: Path) -> None:
    members = Class(str(group), f'{group}.results')
    path = Path(members.result_path(members.entries[0]))
    path.parent.mkdir(parents=True)
    path.write_text('{"student": "an')
    assert members.result(members.entries[0]) is None


def test_a_text_of_a_student_is_no_formula_and_no_markup() -> None:
    row = (Entry('=x/<b>.launch.py', '=x'), {'refused': '<script>', 'exit_code': 2})
    assert "\n'=x,'=x/<b>.launch.py," in class_csv([row])
    assert '<script>' not in class_page([row])
    assert 'href="%3Dx/%3Cb%3E.launch.py.html"' in class_page([row])


def test_a_folder_that_is_none_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['batch', 'nowhere']) == 2
    assert 'nowhere is not a folder' in capsys.readouterr().err

"""Marks as Moodle and Canvas import them: everybody gets the own one, nobody a zero for no mark."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.export.platforms import Mark, marks_of
from edugrade.cli import main

from edulaunch.errors import UnusableInput

WORKSHEET = (
    '\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed","Last modified (grade)","Feedback comments"\r\n'
    'Participant 11,"Ada Lovelace",ada@example.org,"Submitted for grading",,12.00,Yes,-,\r\n'
    'Participant 12,"Bob",b@example.org,"Submitted for grading",,12.00,Yes,-,\r\n'
    'Participant 13,"Cleo",c@example.org,"No submission",5,12.00,Yes,-,old\r\n'
    'Participant 14,"Dan, the Man",d@example.org,"No submission",,12.00,Yes,-,\r\n'
)
GRADEBOOK = (
    'Student,ID,SIS User ID,SIS Login ID,Section,circle (99),Final Score\n'
    '    Points Possible,,,,,10,(read only)\n'
    '"Lovelace, Ada",11,s11,ada,A,,3\n'
    '"Bob",12,s12,bob,A,,3\n'
    '"Cleo",13,s13,cleo,A,5,3\n'
    '"Student, Test",,,,A,,\n'
)


def result(student: str, number: str, earned: float | None, path: str, exercise: str = 'circle') -> dict[str, Any]:
    found: dict[str, Any] = {'student': student, 'student_id': number, 'path': path, 'rubric': {'name': exercise}}
    check = {'status': 'passed' if earned == 12 else 'failed', 'reason': '=wrong'}
    return {
        **found,
        'points': {'earned': earned, 'possible': 12},
        'exit_code': 1,
        'checks': [check],
        'sandbox': {'files': 'held'},
    }


RESULTS = [
    result('Ada Lovelace', '11', 7.5, 'a/circle'),
    result('Ada Lovelace', '11', 12, 'a/again/circle'),
    result('Bob', '', 0, 'b/circle'),
    {'student': 'Cleo', 'student_id': '13', 'path': 'c', 'exit_code': 2, 'refused': 'no file', 'verdict': 'unusable input'},
    result('Eve', '15', 3, 'e/circle'),
]


@pytest.fixture
def results(tmp_path: Path) -> Path:
    for found in RESULTS:
        path = tmp_path / 'results' / f'{found["path"]}.json'
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(found))
    (tmp_path / 'worksheet.csv').write_text(WORKSHEET)
    (tmp_path / 'gradebook.csv').write_text(GRADEBOOK)
    return tmp_path / 'results'


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_bytes().decode('utf-8'))))


def test_the_best_submission_counts_and_no_mark_is_no_zero() -> None:
    assert marks_of(RESULTS) == (
        'circle',
        [
            Mark('Ada Lovelace', '11', 12, 12, 'All checks passed.'),
            Mark('Bob', '', 0, 12, '=wrong'),
            Mark('Cleo', '13', None, 12, 'Not graded: no file'),
            Mark('Eve', '15', 3, 12, '=wrong'),
        ],
    )


def test_several_exercises_must_be_named() -> None:
    with pytest.raises(UnusableInput, match='circle, follow'):
        marks_of([*RESULTS, result('Ada', '1', 1, 'x', 'follow')])


def test_the_worksheet_of_moodle_is_filled_in(results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ['export', 'moodle', str(results), '--list', str(tmp_path / 'worksheet.csv'), '--out', str(tmp_path / 'out.csv')]
    assert main(words) == 1
    assert 'not in the list: Eve' in capsys.readouterr().out
    found = rows(tmp_path / 'out.csv')
    assert [row['Grade'] for row in found] == ['12', '0', '5', '']
    assert [row['Feedback comments'] for row in found] == ['All checks passed.', "'=wrong", 'Not graded: no file', '']
    assert list(found[0]) == list(csv.DictReader(io.StringIO(WORKSHEET.lstrip('\ufeff'))).fieldnames or ())


def test_another_maximum_is_refused(results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'worksheet.csv').write_text(WORKSHEET.replace('12.00', '100,00'.replace(',', '.')))
    words = ['export', 'moodle', str(results), '--list', str(tmp_path / 'worksheet.csv'), '--out', str(tmp_path / 'out.csv')]
    assert main(words) == 2
    assert 'out of 100.00' in capsys.readouterr().err


def test_a_plain_import_for_moodle(results: Path, tmp_path: Path) -> None:
    assert main(['export', 'moodle', str(results), '--out', str(tmp_path / 'out.csv'), '--title', 'Week 1']) == 0
    assert [(row['Full name'], row['ID number'], row['Week 1']) for row in rows(tmp_path / 'out.csv')] == [
        ('Ada Lovelace', '11', '12'),
        ('Bob', '', '0'),
        ('Cleo', '13', ''),
        ('Eve', '15', '3'),
    ]


def test_the_gradebook_of_canvas_gets_its_column(results: Path, tmp_path: Path) -> None:
    words = ['export', 'canvas', str(results), '--list', str(tmp_path / 'gradebook.csv'), '--out', str(tmp_path / 'out.csv')]
    assert main(words) == 1
    found = rows(tmp_path / 'out.csv')
    assert list(found[0]) == ['Student', 'ID', 'SIS User ID', 'SIS Login ID', 'Section', 'circle (99)']
    assert [(row['Student'].strip(), row['circle (99)']) for row in found] == [
        ('Points Possible', '12'),
        ('Lovelace, Ada', '12'),
        ('Bob', '0'),
        ('Cleo', '5'),
    ]


def test_two_of_one_name_are_known_by_their_numbers_only(results: Path, tmp_path: Path) -> None:
    (results / 'b' / 'two.json').write_text(json.dumps(result('Bob', '77', 9, 'b/two')))
    words = ['export', 'canvas', str(results), '--list', str(tmp_path / 'gradebook.csv'), '--out', str(tmp_path / 'out.csv')]
    assert main(words) == 1
    assert 'Bob' not in [row['Student'] for row in rows(tmp_path / 'out.csv')]


@pytest.mark.parametrize('platform', ['moodle', 'canvas'])
def test_a_list_of_something_else_is_refused(results: Path, tmp_path: Path, platform: str) -> None:
    (tmp_path / 'x.csv').write_bytes(b'a,b\n1,2\n')
    assert main(['export', platform, str(results), '--list', str(tmp_path / 'x.csv'), '--out', str(tmp_path / 'out.csv')]) == 2
    (tmp_path / 'x.csv').write_bytes(b'\xff\xfe\x00')
    assert main(['export', platform, str(results), '--list', str(tmp_path / 'x.csv'), '--out', str(tmp_path / 'out.csv')]) == 2
    assert not (tmp_path / 'out.csv').exists()

"""A teacher's points and comments, and lateness: they count in tables and exports, and survive another grading."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.decisions import decided, read_decisions, read_late
from edugrade.classes.export.platforms import main

from edulaunch.errors import UnusableInput

HELD = {'files': 'held', 'network': 'held'}


def result(student: str, exercise: str, earned: float | None, **more: Any) -> dict[str, Any]:
    points = {'earned': earned, 'possible': 12}
    return {'student': student, 'path': f'{student}/{exercise}', 'rubric': {'name': exercise}, 'points': points, 'checks': []} | {
        'sandbox': HELD,
        **more,
    }


def write(folder: Path, text: str, name: str = 'teacher.csv') -> str:
    (folder / name).write_text(text)
    return str(folder / name)


def test_points_and_comments_of_the_teacher_count(tmp_path: Path) -> None:
    write(tmp_path, 'student,exercise,points,comment\nanna,circle,9.5,shown in class\nbert,,,well done\n')
    results = [result('anna', 'circle', 4), result('anna', 'follow', 5), result('bert', 'circle', 12)]
    found = decided(results, str(tmp_path))
    assert [each['points']['earned'] for each in found] == [9.5, 5, 12]
    assert [(each.get('graded'), each.get('comment')) for each in found] == [
        (4, 'shown in class'),
        (None, None),
        (None, 'well done'),
    ]


def test_a_spreadsheet_with_semicolons_and_decimal_commas_is_read(tmp_path: Path) -> None:
    path = write(tmp_path, '\ufeffstudent;exercise;points;comment\nanna;circle;9,5;ja, gut\n')
    assert read_decisions(path) == {('anna', 'circle'): (9.5, 'ja, gut')}


@pytest.mark.parametrize(
    ('text', 'told'),
    [
        ('student,exercise,points\nanna,circle,many\n', ":2: 'many' is not a valid number of points"),
        ('student,exercise,points\nanna,circle,-3\n', ":2: '-3' is not a valid number of points"),
        ('student,exercise,points\nanna,circle,nan\n', ":2: 'nan' is not a valid number of points"),
        ('name,mark\nanna,3\n', 'has no columns student and points'),
        (
            'student,exercise,points\nana,circle,3\n',
            'teacher.csv names ana, who has no result\n  help: write anna, or remove the line',
        ),
        ('student,exercise,points\nanna,follow,3\n', 'teacher.csv: anna has no result of follow\n  help: write one of circle'),
    ],
)
def test_a_mistake_in_it_is_said_with_its_line(tmp_path: Path, text: str, told: str) -> None:
    write(tmp_path, text)
    with pytest.raises(UnusableInput) as raised:
        decided([result('anna', 'circle', 4)], str(tmp_path))
    assert told in str(raised.value)


@pytest.mark.parametrize(
    ('submitted', 'earned', 'days'),
    [
        ('2026-11-20T23:00', 10, None),
        ('2026-11-21T00:30', 9, 1),
        ('2026-11-23 23:58', 7, 3),
        ('2027-11-23', 0, 368),
        ('Saturday, 21 November 2026, 1:00 AM', 9, 1),
    ],
)
def test_lateness_takes_off_a_share_for_each_day_that_has_begun(
    tmp_path: Path, submitted: str, earned: float, days: int | None
) -> None:
    late = read_late('2026-11-20T23:59', 10.0, write(tmp_path, f'student,submitted\nanna,"{submitted}"\n', 'times.csv'))
    (found,) = decided([result('anna', 'circle', 10)], str(tmp_path / 'none'), late)
    assert (found['points']['earned'], found.get('late_days')) == (earned, days)


def test_what_the_teacher_decides_is_final_and_no_mark_stays_none(tmp_path: Path) -> None:
    write(tmp_path, 'student,exercise,points\nanna,circle,10\n')
    late = read_late(
        '2026-11-20T23:59', 10.0, write(tmp_path, 'student,submitted\nanna,2026-11-22\nbert,2026-11-22\n', 'times.csv')
    )
    found = decided([result('anna', 'circle', 2), result('bert', 'circle', None)], str(tmp_path), late)
    assert [each['points']['earned'] for each in found] == [10, None]


def test_times_with_and_without_a_zone_are_not_compared(tmp_path: Path) -> None:
    late = read_late('2026-11-20T23:59', 10.0, write(tmp_path, 'student,submitted\nanna,2026-11-22T00:00+01:00\n', 'times.csv'))
    with pytest.raises(UnusableInput, match='time zone'):
        decided([result('anna', 'circle', 2)], str(tmp_path), late)


@pytest.fixture
def results(tmp_path: Path) -> Path:
    folder = tmp_path / 'results'
    folder.mkdir()
    rows = [
        result('anna', 'circle', 12),
        result('anna', 'follow', 7),
        result('=1+1', 'circle', None),
        result('bert', 'circle', 3, sandbox={**HELD, 'network': 'no seccomp'}),
    ]
    for number, row in enumerate(rows):
        (folder / f'{number}.json').write_text(json.dumps(row))
    return folder


def test_one_table_has_all_exercises(results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(results, 'student,exercise,points,comment\nanna,follow,9,talked about it\n')
    out = tmp_path / 'marks.csv'
    assert main(['table', str(results), '--out', str(out), '--separator', ';']) == 0
    remark = '"talked about it. 9 points count; the checks gave 7."'
    unconfined = 'files; without network (no seccomp)'
    head, *lines = out.read_text().splitlines()
    assert head == 'student;student_id;circle;follow;points;possible;without_mark;remarks;sandbox'
    assert sorted(lines) == [
        "'=1+1;;;;0;24;circle;;files, network",
        f'anna;;12;9;21;24;;{remark};files, network',
        f'bert;;3;;3;24;;"Runs: {unconfined}.";"{unconfined}"',
    ]
    assert capsys.readouterr().out.startswith('1 of these marks come from runs without a complete sandbox')


def test_a_platform_reads_what_did_not_confine_a_mark(results: Path, tmp_path: Path) -> None:
    out = tmp_path / 'marks.csv'
    assert main(['moodle', str(results), '--out', str(out), '--exercise', 'circle']) == 0
    assert 'All checks passed. Runs: files; without network (no seccomp).' in out.read_text()


def test_due_and_submitted_belong_together(results: Path, tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='--due needs --submitted'):
        main(['table', str(results), '--out', str(tmp_path / 'm.csv'), '--due', '2026-11-20'])


def test_a_platform_with_semicolons_gets_semicolons(results: Path, tmp_path: Path) -> None:
    out, own = tmp_path / 'marks.csv', tmp_path / 'worksheet.csv'
    write(results, 'student,exercise,points,comment\nanna,circle,9,talked about it\n')
    assert main(['moodle', str(results), '--exercise', 'circle', '--out', str(out), '--separator', ';']) == 0
    assert out.read_text().splitlines()[0] == 'Full name;ID number;circle;circle (feedback)'
    assert 'anna;;9;"All checks passed. talked about it. 9 points count' in out.read_text()
    own.write_text('Identifier;Full name;Grade\nParticipant 1;anna;\nParticipant 2;bert;\nParticipant 3;=1+1;\n')
    assert main(['moodle', str(results), '--exercise', 'circle', '--out', str(out), '--list', str(own)]) == 0
    assert out.read_text().splitlines()[:3] == ['Identifier;Full name;Grade', 'Participant 1;anna;9', 'Participant 2;bert;3']

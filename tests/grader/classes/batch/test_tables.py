"""The class page names its columns as the documentation does, and says in one word that the sandbox was complete."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.store import Store
from edugrade.classes.batch.tables import (
    class_csv,
    class_page,
    confined_by,
    csv_text,
    first_problem,
    one_line,
    plain,
    rows,
    student_file,
    student_page,
    write_pages,
)
from edugrade.results import BROKEN_GRADER, OWN_VARIANT


@pytest.mark.parametrize(
    ('layers', 'shown'),
    [
        ({'files': 'held', 'network': 'held'}, '<td>complete</td>'),
        ({'files': 'held', 'view': 'not available'}, '<td>files; without view (not available)</td>'),
        ({}, '<td>not confined</td>'),
    ],
)
def test_the_page_says_whether_the_sandbox_was_complete(layers: dict[str, str], shown: str) -> None:
    found = {'checks': [], 'sandbox': layers, 'verdict': 'all passed', 'exit_code': 0, 'rubric': {'name': 'circle'}}
    page = class_page([(Entry('anna/circle.launch.py', 'Anna'), found)], {})
    assert shown in page
    assert '<h1>Marks of the class</h1>' in page and '<th>outcome</th>' in page and 'verdict' not in page


def check(
    status: str, sentence: str = 'The robot drives', reason: str | None = None, points: int = 4, earned: int = 0, **more: Any
) -> dict[str, Any]:
    return {
        'name': sentence,
        'sentence': sentence,
        'status': status,
        'reason': reason,
        'seen': None,
        'try': None,
        'points': points,
        'earned': earned,
        **more,
    }


def graded(earned: float, *checks: dict[str, Any], **more: Any) -> Any:
    return {
        'checks': list(checks),
        'verdict': 'some failed',
        'points': {'earned': earned, 'possible': 12},
        'rubric': {'name': 'circle'},
        'sandbox': {'files': 'held'},
        'exit_code': 1,
        'run_s': 0.5,
        'receipt': {'submission': 'abc', 'seed': 7},
        'graded': '2026-11-24',
        'comment': 'well done',
        **more,
    }


ANNA = Entry('anna/circle.launch.py', 'Anna', '17', origin='moodle')
BEN = Entry('ben/circle.launch.py', 'Ben')
CARL = Entry('carl.zip', 'Carl')
FAILED = check('failed', reason='it stands still:\nno velocity', seen='0 m/s', **{'try': 'publish <Twist>'})
CLASS: Any = [
    (ANNA, graded(9, check('passed', earned=4), check('not_run', 'The turtle turns'))),
    (BEN, graded(4.5, FAILED, check('passed', 'The turtle turns', points=0))),
    (CARL, {'refused': 'the archive is damaged', 'help': 'hand in another one'}),
]


def test_a_row_has_the_facts_of_a_submission_and_no_mark_is_no_zero() -> None:
    assert class_csv(CLASS).splitlines() == [
        'student,student_id,submission,exercise,verdict,earned,possible,first_problem,sha256,seed,origin,sandbox,run_s,graded,comment',
        'Anna,17,anna/circle.launch.py,circle,some failed,9,12,,abc,7,moodle,files,0.5,2026-11-24,well done',
        'Ben,,ben/circle.launch.py,circle,some failed,4.5,12,it stands still: no velocity,abc,7,,files,0.5,2026-11-24,well done',
        'Carl,,carl.zip,,not graded,,,the archive is damaged,,,,,,,',
    ]
    assert rows([(BEN, None)])[0]['first_problem'] == 'not graded yet'


def test_a_copied_variant_is_not_graded() -> None:
    assert rows([(ANNA, graded(9, check('failed', name=OWN_VARIANT)))])[0]['verdict'] == 'not graded'


@pytest.mark.parametrize(
    ('found', 'told'),
    [
        ({'checks': [], 'sandbox': {'files': 'held', 'view': 'held'}}, 'files, view'),
        (
            {'checks': [], 'sandbox': {'view': 'not available', 'limits': 'off'}},
            'not confined; without view (not available), limits (off)',
        ),
        ({'checks': [], 'exit_code': BROKEN_GRADER}, ''),
        ({'checks': []}, 'not confined'),
        ({'sandbox': {'files': 'held'}}, ''),
    ],
)
def test_a_row_names_the_layers_that_confined_a_run(found: Any, told: str) -> None:
    assert confined_by(found) == told


@pytest.mark.parametrize(
    ('text', 'line'),
    [
        ('', ''),
        ('\n\n', ''),
        ('one\ntwo', 'one'),
        ('it fails:\n  - the first\n  - the second', 'it fails: the first'),
        ('Caught several exceptions:\n - the first', 'the first'),
        ('it fails:', 'it fails:'),
    ],
)
def test_a_problem_is_one_line(text: str, line: str) -> None:
    assert one_line(text) == line


def test_the_first_problem_is_that_of_the_first_check_that_did_not_pass() -> None:
    checks = [
        check('passed', reason='a'),
        check('not_run', reason='b'),
        check('grader_broke', reason='c'),
        check('failed', reason='d'),
    ]
    assert first_problem({'checks': checks}) == 'c'  # type: ignore[typeddict-item]
    assert first_problem({'checks': checks[:2]}) is None  # type: ignore[typeddict-item]


@pytest.mark.parametrize(
    ('cell', 'shown'),
    [
        ('=1+1', "'=1+1"),
        ('+1', "'+1"),
        ('-1', "'-1"),
        ('@x', "'@x"),
        ('\tx', "'\tx"),
        ('a\x07b\nc', 'a?b\nc'),
        ('a; =x', "a; '=x"),
        ('a|"=x', 'a|"\'=x'),
        ('a,=x', 'a,=x'),
        ('a b', 'a b'),
    ],
)
def test_no_cell_is_a_formula(cell: str, shown: str) -> None:
    assert plain(cell) == shown


def test_a_table_with_semicolons_has_decimal_commas() -> None:
    lines = [{'a': '9.6', 'b': 'x,=y'}, {'a': '1.2.3', 'b': '-4'}]
    assert csv_text(('a', 'b'), lines, ';') == "a;b\n9,6;x,'=y\n1.2.3;'-4\n"
    assert csv_text(('a', 'b'), lines) == 'a,b\n9.6,"x,=y"\n1.2.3,\'-4\n'


def text_of(page: str) -> list[str]:
    """The visible text of a page, a line for each element."""
    body = page.split('<body', 1)[1].split('>', 1)[1]
    return [line for line in re.sub(r'<[^>]*>', '\n', body).splitlines() if line.strip()]


def test_the_class_page_has_marks_causes_and_checks() -> None:
    page = class_page([*CLASS, (Entry('d.py', 'Dora'), graded(12, FAILED))], {'ben/circle.launch.py': 'ben/a b.html'})
    assert text_of(page) == [
        'Marks of the class',
        'circle (of 12): 3 marks, 4.5 to 12, median 9, mean 8.5.',
        '1 submissions could not be graded. They have no mark, which differs from zero points.',
        *('student', 'submission', 'exercise', 'outcome', 'earned', 'possible', 'sandbox', 'first problem'),
        *('Anna', 'anna/circle.launch.py', 'circle', 'some failed', '9', '12', 'complete'),
        *('Ben', 'ben/circle.launch.py', 'circle', 'some failed', '4.5', '12', 'complete', 'it stands still: no velocity'),
        *('Carl', 'carl.zip', 'not graded', 'the archive is damaged'),
        *('Dora', 'd.py', 'circle', 'some failed', '12', '12', 'complete', 'it stands still: no velocity'),
        'Most common causes',
        *('submissions', 'exercise', 'check', 'cause'),
        *('2', 'circle', 'The robot drives', 'it stands still: no velocity'),
        *('1', 'The submission can be graded', 'the archive is damaged'),
        'Checks',
        *('exercise', 'check', 'passed', 'failed', 'not run'),
        *('circle', 'The robot drives', '1', '2', '0'),
        *('circle', 'The turtle turns', '1', '0', '1'),
    ]
    assert '<a href="ben/a%20b.html">ben/circle.launch.py</a>' in page
    assert f'<a href="{student_file("Anna", "17")}">Anna</a>' in page and '<title>edugrade: Marks of the class</title>' in page


@pytest.mark.parametrize(
    ('marks', 'line'), [([3], '1 mark, 3 to 3, median 3, mean 3.0.'), ([8, 3], '2 marks, 3 to 8, median 5.5, mean 5.5.')]
)
def test_marks_have_a_median(marks: list[float], line: str) -> None:
    page = class_page([(ANNA, graded(mark)) for mark in marks], {})
    assert f'circle (of 12): {line}' in text_of(page) and 'could not be graded' not in page


def test_the_class_page_has_the_twenty_most_common_causes() -> None:
    page = class_page([(ANNA, graded(0, check('failed', reason=f'cause {number:02}'))) for number in range(25)], {})
    causes = text_of(page)[text_of(page).index('Most common causes') :]
    assert [line for line in causes if line.startswith('cause ')] == [f'cause {number:02}' for number in range(20)]


def test_the_page_of_a_student_has_each_check() -> None:
    page = student_page('Ben', [CLASS[1], CLASS[2]], {'ben/circle.launch.py': 'pages/ben.html'})
    assert text_of(page) == [
        'Ben',
        'circle: 4.5 of 12 points',
        *('ben/circle.launch.py', ' some failed'),
        *('check', 'result', 'points', 'why', 'seen', 'try'),
        *('The robot drives', 'failed', '0 of 4', 'it stands still:', 'no velocity', '0 m/s', 'publish &lt;Twist&gt;'),
        *('The turtle turns', 'passed'),
        'carl.zip: no mark',
        'carl.zip not graded',
        'the archive is damaged. hand in another one',
    ]
    assert 'href="../pages/ben.html"' in page and '<title>edugrade: Ben</title>' in page


def test_the_file_of_a_student_is_readable_and_unique() -> None:
    assert student_file('Zoë O./x')[:18] == 'students/Zoë_O__x-'
    assert len({student_file('A B'), student_file('A_B'), student_file('A B', '1')}) == 3
    assert len(student_file('x' * 500)) == len('students/') + 80 + len('-12345678.html')


def test_the_pages_link_to_each_other(tmp_path: Path) -> None:
    store = Store(str(tmp_path / 'store'))
    made = Path(store.path(ANNA, '.html', str(tmp_path)))
    made.parent.mkdir(parents=True, exist_ok=True)
    made.write_text('')
    write_pages(str(tmp_path), CLASS, store)
    assert sorted(path.name for path in (tmp_path / 'students').iterdir()) == sorted(
        student_file(entry.student, entry.id).removeprefix('students/') for entry in (ANNA, BEN, CARL)
    )
    link = os.path.relpath(made, tmp_path)
    assert f'href="{link}"' in (tmp_path / 'index.html').read_text()
    assert f'href="../{link}"' in (tmp_path / student_file('Anna', '17')).read_text()
    assert 'href' not in (tmp_path / student_file('Ben')).read_text()

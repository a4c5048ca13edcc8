"""A class is graded one result at a time: none is lost, none is done twice, none costs another its mark."""

from __future__ import annotations

import csv
import errno
import io
import itertools
import json
import os
import shutil
import signal
from pathlib import Path
from typing import Any, NoReturn

import pytest
from edugrade import verdicts
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.store import Store
from edugrade.classes.batch.tables import class_csv, class_page, confined_by, csv_text, one_line, plain
from edugrade.classes.batch.work import Options, work_to_do
from edugrade.cli import main

SOLUTIONS = Path(__file__).parents[4] / 'solutions'
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
    save = Store.save

    def last(self: Store, entry: Entry, content: dict[str, Any]) -> None:
        if next(made) > number:
            os.kill(os.getpid(), signal.SIGKILL)
        save(self, entry, content)

    monkeypatch.setattr(Store, 'save', last)
    main(['batch', str(group), '--resume'])
    os._exit(9)


@pytest.mark.processes
def test_each_submission_has_its_result_and_a_line_in_the_table(group: Path, tmp_path: Path) -> None:
    assert main(['batch', str(group), '--csv', str(tmp_path / 'marks.csv'), '--html', str(tmp_path / 'pages')]) == 0
    rows = list(csv.DictReader(io.StringIO((tmp_path / 'marks.csv').read_text())))
    assert [(row['student'], row['earned']) for row in rows] == [
        *((name, '12') for name in STUDENTS),
        ('mallory', '0'),
        ('peter', ''),
    ]
    assert rows[4]['first_problem'] == 'SIGKILL ended the program before the end of the run'
    assert 'regular file' in rows[5]['first_problem']
    page = (tmp_path / 'pages' / 'index.html').read_text()
    assert 'href="anna/static_frame.launch.py.html"' in page
    assert (tmp_path / 'pages' / 'anna' / 'static_frame.launch.py.html').read_text().count('<section') == 1
    assert os.listdir(tmp_path / 'private') == []


@pytest.mark.whole
def test_a_killed_grader_goes_on_where_it_was(group: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert main(['batch', str(group)]) == 0
    whole = results(group)
    shutil.rmtree(f'{group}.results')
    saved: list[str] = []
    save = Store.save

    def counted(self: Store, entry: Entry, content: dict[str, Any]) -> None:
        save(self, entry, content)
        saved.append(entry.student)

    monkeypatch.setattr(Store, 'save', counted)
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


def test_a_strange_name_in_the_teachers_file_is_found_before_anything_runs(
    group: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    results_folder = Path(f'{group}.results')
    results_folder.mkdir()
    (results_folder / 'teacher.csv').write_text('student,points\nana,3\n')
    assert main(['batch', str(group)]) == 2
    said = f'edugrade: {results_folder}/teacher.csv names ana, who has no result\n  help: write anna, or remove the line\n'
    assert capsys.readouterr().err == said
    assert results(group) == {}


@pytest.mark.processes
def test_an_edit_is_graded_again_and_the_rest_is_kept(group: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(['batch', str(group)])
    (group / 'anna' / 'static_frame.launch.py').write_text('x = 1\n')
    main(['batch', str(group), '--resume'])
    assert '6 submissions, 4 of them from an earlier batch; 5 have a mark.' in capsys.readouterr().out
    found = json.loads(results(group)['anna/static_frame.launch.py.json'])
    assert (found['student'], found['points']['earned']) == ('anna', 0)


def test_half_a_result_is_no_result(group: Path) -> None:
    store, entry = Store(f'{group}.results'), Entry('anna/static_frame.launch.py', 'anna')
    path = Path(store.path(entry))
    path.parent.mkdir(parents=True)
    path.write_text('{"student": "an')
    assert store.result(entry) is None


def test_a_text_of_a_student_is_no_formula_and_no_markup() -> None:
    row = (Entry('=x/<b>.launch.py', '=x'), {'refused': '<script>', 'exit_code': 2})
    assert "\n'=x,,'=x/<b>.launch.py," in class_csv([row])
    page = class_page([row], {'=x/<b>.launch.py': '=x/<b>.launch.py.html'})
    assert '<script>' not in page
    assert 'href="%3Dx/%3Cb%3E.launch.py.html"' in page


@pytest.mark.parametrize(
    'words',
    [
        ['nowhere'],
        ['nowhere.csv'],
        ['nowhere.zip'],
        ['empty'],
        ['empty', '--out', 'marks'],
        ['odd.zip'],
        ['empty', '--rubric', 'no'],
    ],
)
def test_what_cannot_be_graded_leaves_nothing_behind(
    words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'empty').mkdir()
    (tmp_path / 'odd.zip').write_text('no archive')
    before = sorted(tmp_path.iterdir())
    assert main(['batch', *words]) == 2
    assert sorted(tmp_path.iterdir()) == before
    assert capsys.readouterr().err.startswith('edugrade: ')


def test_results_that_were_there_stay_when_nothing_can_be_graded(tmp_path: Path) -> None:
    (tmp_path / 'empty').mkdir()
    (tmp_path / 'empty.results').mkdir()
    assert main(['batch', str(tmp_path / 'empty')]) == 2
    assert (tmp_path / 'empty.results').is_dir()


RUBRIC = """
from edugrade import Evidence, Failure, Rubric, Scenario, check

@check(points=4)
def a(run: Evidence) -> None:
    'The first'

@check(points=2)
def b(run: Evidence) -> None:
    'The second'
    raise Failure('wrong', share={share})

RUBRIC = Rubric(title='Two', scenarios=lambda random: [Scenario('one', {{}}, 1.0)], checks=[a, b])
"""


@pytest.fixture
def two(tmp_path: Path) -> tuple[Path, Path]:
    """A student's folder, and a rubric whose second check gives a quarter of its points."""
    (tmp_path / 'class' / 'anna').mkdir(parents=True)
    text = (SOLUTIONS / 'static_frame.launch.py').read_text()
    (tmp_path / 'class' / 'anna' / 'two.launch.py').write_text(text)
    (tmp_path / 'two.py').write_text(RUBRIC.format(share=0.25))
    return tmp_path / 'class', tmp_path / 'two.py'


@pytest.mark.processes
def test_one_check_is_graded_again_and_the_rest_is_kept(two: tuple[Path, Path]) -> None:
    folder, rubric = two
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 0
    path = Path(f'{folder}.results/anna/two.launch.py.json')
    first = json.loads(path.read_text())
    assert first['points'] == {'earned': 4.5, 'possible': 6}
    first['checks'][1]['reason'] = 'kept'
    path.write_text(json.dumps(first))
    rubric.write_text(RUBRIC.format(share=0.5))
    assert main(['batch', str(folder), '--rubric', str(rubric), '--only', 'b']) == 0
    again = json.loads(path.read_text())
    assert again['points'] == {'earned': 5, 'possible': 6}
    assert (again['checks'][1]['reason'], again['regraded']) == ('kept', ['b'])
    assert again['receipt']['rubric'] != first['receipt']['rubric']


def test_a_check_that_no_rubric_has_changes_no_result(two: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    folder, rubric = two
    result = Path(f'{folder}.results/anna/two.launch.py.json')
    result.parent.mkdir(parents=True)
    result.write_text('{}')
    assert main(['batch', str(folder), '--rubric', str(rubric), '--only', 'c']) == 2
    assert 'the rubric "Two" has no check named "c"' in capsys.readouterr().err
    assert result.read_text() == '{}'


def test_a_check_of_one_exercise_leaves_the_marks_of_the_others(tmp_path: Path) -> None:
    for name in ('static_frame', 'water'):
        (tmp_path / 'class' / 'anna').mkdir(parents=True, exist_ok=True)
        shutil.copy(SOLUTIONS / f'{name}.launch.py', tmp_path / 'class' / 'anna')
    store = Store(str(tmp_path / 'results'))
    entries = [Entry(f'anna/{file.name}', 'anna', file=str(file)) for file in sorted((tmp_path / 'class' / 'anna').iterdir())]
    for entry in entries:
        store.save(entry, {'points': {'earned': 12}})
    todo = list(work_to_do(entries, store, Options(only='green_water')))
    assert [entry.path for entry, _ in todo] == ['anna/water.launch.py']
    assert [(store.result(entry) or {})['points'] for entry in entries] == [{'earned': 12}] * 2


@pytest.mark.processes
def test_the_student_is_in_every_output(two: tuple[Path, Path], tmp_path: Path) -> None:
    folder, rubric = two
    (folder / 'anna').rename(folder / 'Anna Ö_12_assignsubmission_file_')
    words = ['--csv', str(tmp_path / 'c'), '--html', str(tmp_path / 'h'), '--junit', str(tmp_path / 'j')]
    assert main(['batch', str(folder), '--rubric', str(rubric), *words]) == 0
    found = json.loads(next(Path(f'{folder}.results').rglob('*.json')).read_text())
    assert (found['student'], found['student_id']) == ('Anna Ö', '12')
    assert (tmp_path / 'c').read_text().splitlines()[1].startswith('Anna Ö,12,')
    assert 'name="two: Anna Ö: ' in (tmp_path / 'j').read_text()
    assert '<property name="student" value="Anna Ö"/>' in (tmp_path / 'j').read_text()
    index = (tmp_path / 'h' / 'index.html').read_text()
    assert '>Anna Ö</a>' in index and 'two (of 6): 1 mark, 4.5 to 4.5, median 4.5, mean 4.5.' in index
    (own,) = (tmp_path / 'h' / 'students').iterdir()
    assert '4.5 of 6 points' in own.read_text()


@pytest.mark.processes
def test_two_batches_do_not_write_into_each_other(two: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    folder, rubric = two
    with Store(f'{folder}.results').locked():
        (Path(f'{folder}.results') / 'x.json.1234.part').write_text('half')
        assert main(['batch', str(folder), '--rubric', str(rubric)]) == 2
    assert 'another batch' in capsys.readouterr().err
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 0
    assert not list(Path(f'{folder}.results').rglob('*.part'))


@pytest.mark.processes
def test_a_fault_of_ours_with_one_is_no_zero_and_costs_nobody_else(
    group: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from edugrade import grading, judging

    judge = judging.judge

    def breaks_once(checks: Any, outcomes: Any, source: Any) -> Any:
        if 'anna' in source.place.file:
            raise KeyError('ours')
        return judge(checks, outcomes, source)

    monkeypatch.setattr(judging, 'judge', breaks_once)
    assert grading is not None and main(['batch', str(group), '--csv', str(tmp_path / 'c')]) == 3
    rows = list(csv.DictReader(io.StringIO((tmp_path / 'c').read_text())))
    assert [row['earned'] for row in rows] == ['', '12', '12', '12', '0', '']
    assert rows[0]['first_problem'] == "the grader broke: KeyError: 'ours'"


@pytest.mark.processes
def test_a_name_too_long_for_a_result_costs_nobody(two: tuple[Path, Path]) -> None:
    folder, rubric = two
    (folder / 'anna' / ('x' * 240 + '.launch.py')).write_bytes((folder / 'anna' / 'two.launch.py').read_bytes())
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 0
    assert len(list(Path(f'{folder}.results').rglob('*.json'))) == 2


@pytest.mark.processes
def test_a_result_that_cannot_be_written_is_no_older_mark(
    two: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """On a full disk the result of another day stays, and is not this one's."""
    folder, rubric = two
    words = ['batch', str(folder), '--rubric', str(rubric), '--csv', str(folder.parent / 'marks.csv')]
    assert main(words) == 0

    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, 'No space left on device')

    with monkeypatch.context() as patched:
        patched.setattr('os.fsync', full)
        assert main(words[:4]) == 3
    said = capsys.readouterr()
    assert '0 have a mark' in said.out and 'No space left on device' in said.err
    assert said.out.endswith('\nNo mark for 1: its result could not be saved\n')
    assert 'free disk space' in said.err and 'name a file' not in said.err
    assert main([*words, '--resume']) == 0


def test_a_folder_that_cannot_be_read_for_a_moment_is_not_empty(
    two: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, rubric = two
    scandir = os.scandir

    def short_of_descriptors(path: str) -> Any:
        if str(path) == str(folder / 'anna'):
            raise OSError(errno.EMFILE, os.strerror(errno.EMFILE), path)
        return scandir(path)

    monkeypatch.setattr(os, 'scandir', short_of_descriptors)
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 3
    assert 'this process has no descriptors left' in capsys.readouterr().err
    assert list(Path(f'{folder}.results').rglob('*.json')) == []


@pytest.mark.processes
def test_a_result_that_the_grader_could_not_make_is_from_no_earlier_batch(
    two: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, rubric = two

    def short_of_memory(report: object) -> Any:
        raise MemoryError

    monkeypatch.setattr('edugrade.classes.batch.work.document', short_of_memory)
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 3
    said = capsys.readouterr().out
    assert said.startswith('1 submissions; 0 have a mark.')
    assert said.endswith('\nNo mark for 1: not graded: this computer has no memory left\n')


def test_a_table_says_what_confined_a_mark_and_is_safe_in_every_country() -> None:
    held = {'checks': [], 'points': {}, 'sandbox': {'files': 'held', 'view': 'no namespaces'}}
    assert confined_by(held) == 'files; without view (no namespaces)'
    assert (confined_by({**held, 'sandbox': {}}), confined_by({'refused': 'x'})) == ('not confined', '')
    assert confined_by({**held, 'sandbox': {}, 'exit_code': 3}) == ''  # it was not run
    assert plain('a;=1+1') == "a;'=1+1" and plain('a; "@b') == 'a; "\'@b' and plain('a;b-c') == 'a;b-c'
    assert one_line('Caught exceptions:\n - SyntaxError: (\n - InvalidXml\n') == 'SyntaxError: ('


@pytest.mark.processes
def test_a_class_gets_no_marks_from_runs_that_are_not_confined(two: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    folder, rubric = two
    monkeypatch.setattr(verdicts, 'unconfined', lambda sandbox: {'files': 'this kernel has none'})
    result = Path(f'{folder}.results/anna/two.launch.py.json')
    assert main(['batch', str(folder), '--rubric', str(rubric)]) == 3
    assert json.loads(result.read_text())['points']['earned'] is None
    assert main(['batch', str(folder), '--rubric', str(rubric), '--sandbox', 'auto']) == 0
    assert json.loads(result.read_text())['points']['earned'] == 4.5


def test_a_table_with_semicolons_has_decimal_commas_and_no_formulas() -> None:
    lines = [{'name': 'Ada, =1+1', 'points': '9.6', 'version': '1.0.0'}]
    assert csv_text(('name', 'points', 'version'), lines, ';').splitlines()[1] == "Ada, '=1+1;9,6;1.0.0"
    assert csv_text(('name', 'points', 'version'), lines).splitlines()[1] == '"Ada, =1+1",9.6,1.0.0'


def test_the_median_of_an_even_number_of_marks_is_between_the_two_in_the_middle() -> None:
    def found(earned: int) -> dict[str, Any]:
        return {'rubric': {'name': 'two'}, 'points': {'earned': earned, 'possible': 12}, 'checks': [], 'verdict': 'some_failed'}

    class_of = [(Entry(f'{earned}.py', str(earned)), found(earned)) for earned in (12, 2)]
    assert 'two (of 12): 2 marks, 2 to 12, median 7, mean 7.0.' in class_page(class_of, {})

"""check() in a cell: finds the file, shows the report of the command, notes the progress."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from edugrade.cli import main
from edugrade.notebook import CheckReport, Note, find_exercise
from edugrade.progress_file import NAME, ProgressFile
from edugrade.reports.terminal import MORE

from edulaunch import check
from edulaunch.errors import UnusableInput

REPOSITORY = Path(__file__).resolve().parents[2]


@pytest.fixture
def lessons(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the notebooks, beside exercises/ and solutions/, as the current folder."""
    for name in ('exercises', 'solutions'):
        shutil.copytree(REPOSITORY / name, tmp_path / name)
    (tmp_path / 'lessons').mkdir()
    monkeypatch.chdir(tmp_path / 'lessons')
    return tmp_path / 'lessons'


def test_the_file_is_searched_upward(lessons: Path) -> None:
    assert find_exercise('circle') == '../exercises/circle.launch.py'
    assert find_exercise('large_project') == '../exercises/large_project'
    assert find_exercise('../solutions/circle.launch.py') == '../solutions/circle.launch.py'


def test_a_file_beside_the_notebook_goes_first(lessons: Path) -> None:
    (lessons / 'circle.launch.py').touch()
    assert find_exercise('circle') == 'circle.launch.py'


def test_a_missing_file_says_where_it_was_looked_for(lessons: Path) -> None:
    shutil.rmtree(lessons.parent / 'exercises')
    with pytest.raises(UnusableInput, match=r'there is no exercises/circle\.launch\.py in .* or in a folder above it'):
        find_exercise('circle')


def test_a_misspelt_exercise_is_a_note_with_the_nearest(lessons: Path) -> None:
    found = check('cirlce')
    assert isinstance(found, Note)
    assert 'write check("circle"), or' in repr(found)
    assert 'write check(&quot;circle&quot;), or' in found._repr_html_()
    assert 'yaml_' not in repr(found), 'no list of everything: where the list is'
    assert 'list all exercises with %edulaunch course list' in repr(check('zzzz'))


@pytest.mark.processes
def test_the_report_is_that_of_the_command(lessons: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = check('static_frame')
    assert isinstance(found, CheckReport)
    main(['../exercises/static_frame.launch.py', '--advice', '1'])
    counted = repr(found).removesuffix(f'\n{MORE}')  # `--advice 1` stays at this level
    assert counted == f'static_frame: some failed, 1 of 12 points\n\n{capsys.readouterr().out}'.rstrip()
    assert counted != repr(found)
    assert '<b>static_frame: some failed, 1 of 12 points</b> ../exercises/static_frame.launch.py' in found._repr_html_()
    assert found.passed is False


@pytest.mark.processes
def test_attempts_hints_and_success_are_noted_beside_the_notebook(lessons: Path) -> None:
    check('static_frame')
    assert repr(check('static_frame', hint=2)).startswith('A laser and a camera on a mast, hint 2 of 3: ')
    check('../solutions/static_frame.launch.py')
    progress = ProgressFile(str(lessons)).of('static_frame')
    assert (progress.attempts, progress.hints, progress.done, progress.best_points) == (2, [2], True, 12)


def test_a_broken_progress_file_is_kept_and_said_so_in_the_report(lessons: Path) -> None:
    (lessons / NAME).write_text('[circle')
    found = check('static_frame', hint=1)
    assert 'It is kept as my_progress.toml.bak' in repr(found)
    assert ProgressFile(str(lessons)).of('static_frame').hints == [1]


def test_a_report_is_shown_even_where_nothing_can_be_written(lessons: Path) -> None:
    (lessons / NAME).mkdir()
    found = check('static_frame', hint=1)
    assert 'Your progress cannot be saved' in repr(found)

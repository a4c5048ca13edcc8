"""The command: what it refuses, and with which exit code.

The table for several submissions.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from edugrade.cli import main, summary
from edugrade.results import Refusal
from made_report import BROKE, FAILED, PASSED, report

from edulaunch.runtime.plugins import plugins

REPOSITORY = Path(__file__).resolve().parents[2]
STATIC = str(REPOSITORY / 'exercises' / 'static_frame.launch.py')
CIRCLE = str(REPOSITORY / 'exercises' / 'circle.launch.py')


def refused(capsys: pytest.CaptureFixture[str], *argv: str) -> tuple[int, str]:
    code = main(argv)
    shown = capsys.readouterr()
    assert shown.out == ''
    return code, shown.err


def test_a_missing_file_is_unusable_input(capsys: pytest.CaptureFixture[str]) -> None:
    code, text = refused(capsys, CIRCLE.replace('circle.', 'cirle.'))
    assert code == 2
    assert text.endswith(f'help: did you mean {CIRCLE}?\n')


def test_a_directory_is_unusable_input(capsys: pytest.CaptureFixture[str]) -> None:
    code, text = refused(capsys, str(REPOSITORY / 'exercises'))
    assert code == 2
    assert 'is a folder' in text
    assert 'circle.launch.py' in text


def test_a_file_without_a_rubric_names_the_known_ones(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / 'cirlce.launch.py'
    file.write_text('')
    code, text = refused(capsys, str(file))
    assert code == 2
    assert 'there is no rubric named "cirlce". Available rubrics: broken_follow, carrot, circle, follow, large_project, static_frame\n'
    assert '  help: write --rubric circle, or write the path of a rubric file' in text


def test_a_rubric_that_breaks_is_the_graders_fault(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    rubric = tmp_path / 'bad.py'
    rubric.write_text('1 / 0\n')
    code, text = refused(capsys, CIRCLE, '--rubric', str(rubric))
    assert (code, text) == (3, f'edugrade: the rubric is wrong: {rubric}:1: ZeroDivisionError: division by zero\n')


def test_a_missing_rubric_file_is_unusable_input(capsys: pytest.CaptureFixture[str]) -> None:
    code, text = refused(capsys, CIRCLE, '--rubric', 'nowhere.py')
    assert code == 2
    assert text.startswith('edugrade: the rubric nowhere.py does not exist')


def test_hints_come_in_three_levels(capsys: pytest.CaptureFixture[str]) -> None:
    assert [main([CIRCLE, '--hint', level]) for level in '123'] == [0, 0, 0]
    lines = capsys.readouterr().out.splitlines()
    assert [line.split(':')[0] for line in lines] == [f'A circle of any radius, hint {n} of 3' for n in (1, 2, 3)]


@pytest.mark.processes
def test_several_paths_end_with_a_table_and_the_worst_exit_code(capsys: pytest.CaptureFixture[str]) -> None:
    folder = REPOSITORY / 'solutions'
    code = main([str(folder / 'static_frame.launch.py'), STATIC, 'nowhere.launch.py'])
    shown = capsys.readouterr()
    assert (code, shown.err.startswith('sandbox: '), shown.err.count('\n')) == (2, True, 1)
    assert shown.out.startswith(f'{STATIC}: A laser and a camera on a mast')  # what passed is in the table alone
    lines = shown.out.splitlines()
    assert [line.split()[-3:] for line in lines if line.startswith('sum')] == [['13', 'of', '24']]
    assert 'nowhere.launch.py was not graded: nowhere.launch.py does not exist' in lines


def test_one_bad_path_alone_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert refused(capsys, 'nowhere.launch.py')[0] == 2


@pytest.mark.processes
def test_all_formats_are_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = {name: str(tmp_path / name) for name in ('json', 'junit')}
    words = [word for name, file in files.items() for word in (f'--{name}', file)]
    assert main([STATIC, STATIC, *words]) == 1
    assert len(json.loads((tmp_path / 'json').read_text())['reports']) == 2
    assert (tmp_path / 'junit').read_text().count('<testsuite ') == 2
    assert main([STATIC, *words]) == 1
    assert json.loads((tmp_path / 'json').read_text())['rubric']['name'] == 'static_frame'


def test_help_shows_examples_and_exit_codes(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(['--help'])
    text = capsys.readouterr().out
    assert 'edugrade exercises/circle.launch.py' in text
    assert '3  the grader failed' in text and '  schema  ' in text
    assert ('batch submissions/' in text) == ('classes' in plugins())


@pytest.mark.processes
def test_the_module_is_the_command_and_loads_no_heavy_package() -> None:
    code = (
        'import sys, edugrade.cli, edugrade.judging, edugrade.reports.terminal, edugrade.library.launched\n'
        'heavy = "numpy", "matplotlib", "rich", "yaml", "asyncio", "greenlet"\n'
        'print([name for name in heavy if name in sys.modules])'
    )
    path = {'PYTHONPATH': f'{REPOSITORY}:{REPOSITORY / "grader"}'}
    shown = subprocess.run([sys.executable, '-c', code], env=path, capture_output=True, text=True, check=True)
    assert shown.stdout == '[]\n'
    module = subprocess.run([sys.executable, '-m', 'edugrade', 'nowhere.launch.py'], env=path, capture_output=True, text=True)
    assert (module.returncode, module.stdout) == (2, '')


EXPECTED = """\
submission   result         checks  points
------------------------------------------
good         all passed     1 of 1  2 of 2
bad          FAILED         1 of 2  2 of 5
odd          BROKE          1 of 2  no mark
nowhere      REFUSED        -       -
------------------------------------------
sum          1 of 4 passed  3 of 5  4 of 10

nowhere was not graded: nowhere does not exist
  help: look
"""


@pytest.mark.processes
def test_a_reader_that_stops_early_is_no_error() -> None:
    reads, writes = os.pipe()
    os.close(reads)
    with os.fdopen(writes, 'w') as pipe:
        done = subprocess.run(
            [sys.executable, '-m', 'edugrade', 'schema'], stdout=pipe, stderr=subprocess.PIPE, text=True, check=False
        )
    assert (done.returncode, done.stderr) == (141, '')


def test_every_submission_has_a_line_in_words() -> None:
    reports = [report(PASSED, given='good'), report(PASSED, FAILED, given='bad'), report(PASSED, BROKE, given='odd')]
    lines = summary(reports, [Refusal('nowhere', 'nowhere does not exist', 'look')]).splitlines()
    assert [line.split() for line in lines if '---' not in line] == [
        line.split() for line in EXPECTED.splitlines() if '---' not in line
    ]


def test_columns_are_aligned() -> None:
    lines = summary([report(PASSED), report(FAILED, given='b' * 40)], []).splitlines()
    assert len({line.index('of') for line in (lines[2], lines[3])}) == 1


def test_a_name_cannot_repaint_the_table() -> None:
    assert '\x1b' not in summary([report(PASSED, given='a\x1b[2J')], [])

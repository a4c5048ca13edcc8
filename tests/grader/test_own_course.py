"""A course of two exercises, written down from docs/own_course_example.md and from nothing else: checked, graded, exported, verified."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from edugrade import course as course_module
from edugrade.cli import main
from edugrade.notebook import CheckReport, check

from edulaunch.course.lessons import contents
from edulaunch.errors import UnusableInput

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(r'`my_course/([\w./]+)`[^\n]*\n```\w+\n(.*?)```\n', re.S)


def write_course(folder: Path) -> Path:
    for name, text in BLOCK.findall((ROOT / 'docs' / 'own_course_example.md').read_text('utf-8')):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


@pytest.fixture
def course(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = write_course(tmp_path / 'my_course')
    monkeypatch.chdir(folder)
    return folder


@pytest.mark.processes
def test_all_of_it_belongs_together(course: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['course']) == 0, capsys.readouterr().out
    assert capsys.readouterr().out == 'course: 2 exercises, 10 points, no mistakes\n'


@pytest.mark.processes
def test_the_command_and_the_cell_find_the_rubrics(course: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['solutions/spin.launch.py', 'solutions/mast.launch.py']) == 0
    assert main(['exercises/spin.launch.py']) == 1
    assert 'try:      check the command that the launch file starts' in capsys.readouterr().out
    assert main(['exercises/spin.launch.py', '--advice', '3']) == 1
    assert 'start ros2 topic pub with -r 10' in capsys.readouterr().out
    assert main(['exercises/mast.launch.py', '--hint', '2']) == 0
    found = check('mast')
    assert isinstance(found, CheckReport)
    assert found.headline == 'mast: some failed, 1 of 4 points'


@pytest.mark.processes
def test_nearly_right_gives_a_part_of_the_points(course: Path) -> None:
    text = (course / 'solutions' / 'spin.launch.py').read_text().replace('z: 1.0', 'z: 0.9')
    (course / 'exercises' / 'spin.launch.py').write_text(text)
    assert main(['exercises/spin.launch.py', '--json', 'report.json']) == 1
    assert json.loads(Path('report.json').read_text())['points'] == {'earned': 4.5, 'possible': 6}


@pytest.mark.processes
def test_a_class_is_graded_and_a_mark_made_again(course: Path) -> None:
    for name in ('anna', 'bert'):
        (course / 'submissions' / name).mkdir(parents=True)
        shutil.copy(course / ('solutions' if name == 'anna' else 'exercises') / 'spin.launch.py', course / 'submissions' / name)
    assert main(['batch', 'submissions', '--csv', 'marks.csv']) == 0
    assert [line.split(',')[5] for line in Path('marks.csv').read_text().splitlines()[1:]] == ['6', '1']
    assert main(['verify', 'submissions.results/bert/spin.launch.py.json']) == 0


@pytest.mark.processes
def test_gradescope_grades_by_the_rubrics(course: Path) -> None:
    for name, points in (('spin', 6), ('mast', 4)):
        assert main(['gradescope', 'build', name, '--out', f'{name}.zip']) == 0
        there = course / f'autograder_{name}'
        shutil.unpack_archive(f'{name}.zip', there / 'source')
        (there / 'submission').mkdir()
        shutil.copy(course / 'solutions' / f'{name}.launch.py', there / 'submission')
        assert main(['gradescope', 'run', str(there)]) == 0
        found = json.loads((there / 'results' / 'results.json').read_text())
        assert (found['score'], sum(test['max_score'] for test in found['tests'])) == (points, points)


@pytest.mark.processes
def test_a_rubric_that_was_handed_in_is_not_run(
    course: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    handed = course / 'submissions' / 'mallory'
    (handed / 'rubrics').mkdir(parents=True)
    (handed / 'course.toml').write_text('')
    (handed / 'rubrics' / 'spin.py').write_text('raise SystemExit(0)')
    shutil.copy(course / 'exercises' / 'spin.launch.py', handed)
    assert main(['submissions/mallory/spin.launch.py']) == 1
    monkeypatch.chdir(handed)
    assert main(['spin.launch.py']) == 2
    assert 'is in the folder of the submission' in capsys.readouterr().err


def test_a_manifest_is_parsed_once_until_it_changes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    parsed: list[str] = []
    parse = course_module.parse_toml
    monkeypatch.setattr(course_module, 'parse_toml', lambda text: parsed.append(text) or parse(text))
    manifest = tmp_path / 'course.toml'
    for points in (3, 3, 4):
        manifest.write_text(f"[[exercise]]\nfile = 'once.launch.py'\ntitle = 'T'\npoints = {points}\n")
        assert [item.points for item in course_module.read_course(str(manifest))] == [points]
    assert len(parsed) == 2


def test_a_course_gives_other_points_for_a_rubric_of_ours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from edugrade.rubrics.catalogue import find_rubric

    entry = "[[exercise]]\nfile = '{}'\ntitle = 'T'\npoints = {}\ncheck_points = {}\n"
    course = tmp_path / 'course.toml'
    course.write_text(
        entry.format('water.launch.py', 13, '{alive = 2}') + entry.format('circle.launch.py', 9, '{circle_is_driven = 1}')
    )
    before = {name: find_rubric(name)[1] for name in ('water', 'circle')}
    monkeypatch.chdir(tmp_path)
    for name, total in (('water', 13), ('circle', 9)):
        found = find_rubric(name)[1]
        assert sum(check.points for check in found.checks) == total
        assert found.sha256 != before[name].sha256
        (tmp_path / 'sent').mkdir(exist_ok=True)
        sent = tmp_path / 'sent' / Path(found.file).name
        sent.write_bytes(found.text)  # as it goes to Gradescope and to a cluster
        assert sum(check.points for check in find_rubric('', str(sent))[1].checks) == total
    course.write_text(entry.format('water.launch.py', 13, '{no_such = 2}'))
    with pytest.raises(UnusableInput, match='check_points of water: there is no check no_such; there are alive, red_water'):
        find_rubric('water')


@pytest.mark.processes
def test_whoever_is_done_reads_why_it_matters(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(ROOT / 'solutions' / 'water.launch.py'), '--sandbox', 'off']) == 0
    assert 'On a robot: If you can set speeds, gains and limits' in capsys.readouterr().out
    assert main([str(ROOT / 'exercises' / 'water.launch.py'), '--sandbox', 'off']) == 1
    assert 'On a robot' not in capsys.readouterr().out
    assert 'speeds, gains and limits' in contents(str(ROOT))

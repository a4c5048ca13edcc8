"""`edulaunch course new|copy|lint|list|status|open|release`, typed as one types them."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import pytest

from edulaunch.course.questions import read_questions
from edulaunch.desk.cli.main import main
from tests.house import ROOT


def course(*words: object) -> int:
    return main(['course', *map(str, words)])


def files(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob('*') if path.is_file())


@pytest.fixture
def mine(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    assert course('new', tmp_path / 'mine') == 0
    capsys.readouterr()
    return tmp_path / 'mine'


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding='utf-8')
    assert old in text
    path.write_text(text.replace(old, new), encoding='utf-8')


@pytest.mark.processes
def test_a_new_course_passes_lint_and_its_solution_passes_everything(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert {'course.toml', 'lessons/.outputs/01_circle.json', 'lessons/conftest.py', 'rubrics/spin.yaml'} <= set(files(mine))
    assert course('lint', mine) == 0
    assert capsys.readouterr().out == 'course: 1 exercise, 6 points, no mistakes\n'


def test_lint_says_no_mistakes_only_if_there_are_none_in_the_lessons_either(
    mine: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(mine / 'solutions' / 'questions.toml', "right = 'c'", "right = 'z'")
    assert course('lint', mine, '--quick') == 1
    said = capsys.readouterr().out
    assert 'the question "radius-of-circle" has no right choice' in said and 'no mistakes' not in said


def test_nothing_is_made_where_something_is(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (mine / 'course.toml').write_text('# mine\n')
    assert course('new', mine) == 2
    assert 'not empty' in capsys.readouterr().err and (mine / 'course.toml').read_text() == '# mine\n'


@pytest.mark.whole
def test_the_lesson_of_a_new_course_gives_what_is_kept(mine: Path, tmp_path: Path) -> None:
    pytest.importorskip('nbval', reason='nbval is not installed')
    words = ['--nbval', '--nbval-current-env', '-q', '-p', 'no:cacheprovider', f'--basetemp={tmp_path / "pt"}', 'lessons']
    done = subprocess.run([sys.executable, '-m', 'pytest', *words], cwd=mine, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_our_course_for_students_gives_nothing_away(tmp_path: Path) -> None:
    assert course('copy', tmp_path / 'copy') == 0
    found = files(tmp_path / 'copy')
    lessons = [name for name in found if name.endswith('.ipynb')]
    assert lessons == sorted(f'lessons/{path.name}' for path in (ROOT / 'lessons').glob('*.ipynb'))
    stubs = subprocess.run(['git', 'ls-files', 'exercises'], cwd=ROOT, capture_output=True, text=True)
    assert stubs.returncode != 0 or [name for name in found if name.startswith('exercises/')] == sorted(stubs.stdout.split())
    assert {'lessons/.questions', 'lessons/checkpoints/after_lesson_9/setup.py'} <= set(
        found
    ) and 'lessons/questions.toml' not in found
    assert not [
        name
        for name in found
        if any(word in name for word in ('solutions', 'rubrics', '.outputs', 'conftest', 'coverage', 'checks', 'notes'))
        and not name.startswith('lessons/checks/')  # what check('radio') in a cell asks: a lesson is nothing without them
    ]
    assert {name.split('/')[0] for name in found} == {'.edulaunch_course.json', 'exercises', 'lessons'}


def test_a_changed_file_is_never_overwritten(mine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    copy = tmp_path / 'copy'
    assert course('copy', copy, '--course', mine) == 0
    (copy / 'exercises' / 'spin.launch.py').write_text('# my work\n')
    edit(mine / 'solutions' / 'questions.toml', '2.0 m/s', '3.0 m/s')
    edit(mine / 'exercises' / 'spin.launch.py', 'TODO 1', 'TODO one')
    (mine / 'lessons' / '02_more.ipynb').write_bytes((mine / 'lessons' / '01_circle.ipynb').read_bytes())
    before = {name: (copy / name).read_bytes() for name in files(copy)}
    capsys.readouterr()
    assert course('copy', copy, '--course', mine) == 2
    told = capsys.readouterr().err
    assert 'nothing was copied, because you changed exercises/spin.launch.py' in told and '--update' in told
    assert {name: (copy / name).read_bytes() for name in files(copy)} == before
    for _ in range(2):  # a second time it is still the student's
        assert course('copy', copy, '--course', mine, '--update') == 0
        assert 'kept, because you changed it: exercises/spin.launch.py' in capsys.readouterr().out
    assert (copy / 'exercises' / 'spin.launch.py').read_text() == '# my work\n'
    assert '3.0 m/s' in read_questions(str(copy / 'lessons' / '.questions')).questions['radius-of-circle'].text
    assert (copy / 'lessons' / '02_more.ipynb').is_file()


def test_a_damaged_record_takes_every_other_file_for_the_students(mine: Path, tmp_path: Path) -> None:
    copy = tmp_path / 'copy'
    course('copy', copy, '--course', mine)
    (copy / '.edulaunch_course.json').write_text('{')
    edit(mine / 'solutions' / 'questions.toml', '2.0 m/s', '3.0 m/s')
    assert course('copy', copy, '--course', mine) == 2
    assert course('copy', copy, '--course', copy) == 2, 'a course is not copied into itself'


def test_a_release_has_neither_solutions_nor_outputs_nor_rubrics(mine: Path, tmp_path: Path) -> None:
    lesson = mine / 'lessons' / '01_circle.ipynb'
    raw = json.loads(lesson.read_text())
    raw['cells'][1] |= {'execution_count': 3, 'outputs': [{'output_type': 'stream', 'name': 'stdout', 'text': 'GIVEN AWAY'}]}
    lesson.write_text(json.dumps(raw))
    for name in ('lessons/my_circle.launch.py', 'lessons/my_progress.toml', 'exercises/solutions/spin.launch.py', 'notes.txt'):
        (mine / name).parent.mkdir(exist_ok=True)
        (mine / name).write_text('GIVEN AWAY')
    wanted = ['README.md', 'course.toml', 'exercises/spin.launch.py', 'lessons/.questions', 'lessons/01_circle.ipynb']
    for out in ('one.zip', 'two.zip', 'folder'):
        assert course('release', mine, tmp_path / out) == 0
    zipped = ZipFile(tmp_path / 'one.zip')
    assert zipped.namelist() == wanted and not any(b'GIVEN AWAY' in zipped.read(name) for name in wanted)
    assert (tmp_path / 'one.zip').read_bytes() == (tmp_path / 'two.zip').read_bytes()
    assert all((tmp_path / 'folder' / name).read_bytes() == zipped.read(name) for name in wanted)
    assert course('release', mine, tmp_path / 'folder') == 2, 'a folder with something in it'
    assert course('release', mine, tmp_path / 'rubrics.zip', '--with-rubrics') == 0
    assert ZipFile(tmp_path / 'rubrics.zip').namelist() == sorted([*wanted, 'rubrics/spin.yaml'])


def test_an_exercise_may_be_called_mine(mine: Path, tmp_path: Path) -> None:
    """Only beside the notebooks a name in my_ is what running them left."""
    for name in ('exercises/my_package/setup.py', 'exercises/my_package/test/conftest.py', 'lessons/my_ws/src/a.py'):
        (mine / name).parent.mkdir(parents=True, exist_ok=True)
        (mine / name).write_text('')
    course('release', mine, tmp_path / 'out')
    assert [name for name in files(tmp_path / 'out') if 'my_' in name] == [
        'exercises/my_package/setup.py',
        'exercises/my_package/test/conftest.py',
    ]


def test_a_link_may_lead_to_a_solution(mine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (mine / 'exercises' / 'help.launch.py').symlink_to(mine / 'solutions' / 'spin.launch.py')
    assert course('release', mine, tmp_path / 'out.zip') == 2
    assert 'help.launch.py is a link' in capsys.readouterr().err


def test_lessons_and_exercises_are_named(mine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(mine / 'exercises')
    assert course('list') == 0
    assert capsys.readouterr().out == (
        '01_circle: 1. A turtle on a circle\n    spin                 6 points  A turtle on a circle\n'
    )
    monkeypatch.chdir(ROOT / 'exercises')
    assert course('list') == 0
    assert '\n    two_rooms           12 points  Two rooms, one topic\n' in capsys.readouterr().out


def test_an_exercise_without_a_lesson_stands_at_the_end(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(mine / 'course.toml', "lesson = '01_circle'\n", '')
    course('list', mine)
    assert capsys.readouterr().out.splitlines()[1:] == ['exercises', '    spin                 6 points  A turtle on a circle']


def test_status_reads_the_progress_beside_the_lessons(
    mine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (mine / 'lessons' / 'my_progress.toml').write_text("[my_answers]\nradius-of-circle = ['a']\n")
    for folder in (mine, mine / 'lessons'):
        monkeypatch.chdir(folder)
        assert course('status') == 0
        told = capsys.readouterr().out
        assert '1. A turtle on a circle  0 of 1' in told and "To repeat: quiz('radius-of-circle')." in told


def test_jupyterlab_opens_where_the_lessons_are(mine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr('importlib.util.find_spec', lambda name: name)
    monkeypatch.setattr('subprocess.call', lambda words, cwd: asked.append((words[1:], cwd)) or 0)
    assert course('open', mine) == 0
    assert asked == [(['-m', 'jupyterlab', '--LabApp.default_url=/lab/tree/lessons'], str(mine))]


def test_open_says_how_jupyterlab_is_installed(
    mine: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr('importlib.util.find_spec', lambda name: None)
    assert course('open', mine) == 2
    assert "pip install '.[notebook]'" in capsys.readouterr().err


@pytest.mark.parametrize('verb', ['lint', 'list', 'open'])
def test_where_no_course_is_the_way_to_one_is_told(verb: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert course(verb, tmp_path) == 2
    told = capsys.readouterr().err
    assert f'there is no course in {tmp_path}' in told and 'edulaunch course new' in told

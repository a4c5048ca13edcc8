"""The program that holds exercises, solutions, rubrics and manifest together; and the course itself before it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from edugrade.course import read_course
from edugrade.course_check import check_entries, check_files, main

REPOSITORY = Path(__file__).resolve().parents[2]
COURSE = read_course(str(REPOSITORY / 'exercises' / 'course.toml'))


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of the course, without its lessons."""
    for name in ('exercises', 'solutions'):
        shutil.copytree(REPOSITORY / name, tmp_path / name, ignore=shutil.ignore_patterns('__pycache__'))
    return tmp_path


def problems(folder: Path) -> list[str]:
    course = read_course(str(folder / 'exercises' / 'course.toml'))
    found = [*check_files(str(folder), course), *check_entries(str(folder), course)]
    return [text.replace(f'{folder}/', '') for text in found]


def edit(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))


def test_the_course_is_in_order(copy: Path) -> None:
    assert problems(copy) == []


def test_the_course_has_its_exercises_in_the_order_of_the_lessons() -> None:
    names = [item.name for item in COURSE]
    assert {'circle', 'static_frame', 'follow', 'broken_follow', 'carrot', 'large_project', 'rooms'} <= set(names)
    assert len(set(names)) == len(names) == 26
    assert [item.lesson for item in COURSE] == sorted(item.lesson for item in COURSE)


def test_a_stub_without_a_solution_is_found(copy: Path) -> None:
    (copy / 'solutions' / 'carrot.launch.py').unlink()
    assert any('carrot.launch.py does not exist' in problem for problem in problems(copy))
    assert list(check_files(str(copy), COURSE)) == ['solutions/carrot.launch.py is missing']


def test_a_stray_file_is_found(copy: Path) -> None:
    for name in ('exercises', 'solutions'):
        (copy / name / 'notes.txt').write_text('x')
    assert problems(copy) == ['exercises/notes.txt belongs to no exercise of course.toml']


def test_an_exercise_that_does_not_say_why_is_found(copy: Path) -> None:
    edit(copy / 'exercises' / 'course.toml', 'why = "The newest', 'what = "The newest')
    assert problems(copy) == ['where_now does not say why it matters on a robot: why = "..." in course.toml']


def test_a_short_hint_is_found(copy: Path) -> None:
    text = (copy / 'exercises' / 'course.toml').read_text()
    start = text.index('"The launch file needs three things')
    (copy / 'exercises' / 'course.toml').write_text(text[:start] + "'short',\n" + text[text.index('\n', start) + 1 :])
    assert problems(copy) == ['circle needs 3 hints of at least 40 characters']


def test_points_and_title_are_those_of_the_rubric(copy: Path) -> None:
    edit(copy / 'exercises' / 'course.toml', 'points = 12', 'points = 11')
    edit(copy / 'exercises' / 'course.toml', 'A circle of any', 'A circle of one')
    assert problems(copy) == [
        'two_channels has 11 points in course.toml, but its checks add up to 12',
        "circle is called 'A circle of one radius' in course.toml and 'A circle of any radius' in its rubric",
    ]


def test_a_lesson_that_is_not_there_is_found(copy: Path) -> None:
    (copy / 'lessons').mkdir()
    for item in COURSE[1:]:
        (copy / 'lessons' / f'{item.lesson}.ipynb').touch()
    assert problems(copy) == ['two_channels names the lesson 00_python, which is not in lessons/']


def test_a_stub_needs_gaps_and_a_solution_has_none(copy: Path) -> None:
    stub, solution = (copy / kind / 'broken_follow.launch.py' for kind in ('exercises', 'solutions'))
    edit(stub, '# TODO:', '# Look:')
    solution.write_text('# TODO left over\n' + solution.read_text())
    assert problems(copy) == [
        'exercises/broken_follow.launch.py has 0 comments # TODO; 1 to 3 are right',
        'solutions/broken_follow.launch.py:1: a solution has no gaps',
    ]


def test_a_solution_far_from_its_stub_is_found(copy: Path) -> None:
    solution = copy / 'solutions' / 'follow.launch.py'
    edit(solution, '    ])', ''.join(f'        # more {n}\n' for n in range(30)) + '    ])')
    assert problems(copy)[0].startswith('solutions/follow.launch.py differs from its stub by ')


def test_the_program_says_what_is_wrong(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(copy), '--quick']) == 0
    assert capsys.readouterr().out == 'course: 26 exercises, 312 points, no mistakes\n'
    edit(copy / 'exercises' / 'course.toml', 'points = 12', 'points = 11')
    assert main([str(copy), '--quick']) == 1
    assert capsys.readouterr().out == 'course: two_channels has 11 points in course.toml, but its checks add up to 12\n'


def test_a_broken_manifest_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'exercises').mkdir()
    (tmp_path / 'exercises' / 'course.toml').write_text('[[exercise]]\nfile = "a"\n')
    assert main([str(tmp_path)]) == 1
    assert 'course: a has no title in course.toml' in capsys.readouterr().out


def test_everything_that_is_wrong_in_a_manifest_is_named_at_once(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = copy / 'exercises' / 'course.toml'
    manifest.write_text("[[exercise]]\nfile = 3\npoints = '12'\n\n[[exercise]]\ntitle = 'A'\npoints = true\nhints = 'no'\n")
    assert main([str(copy), '--quick']) == 1
    assert capsys.readouterr().out.splitlines() == [
        'course: 3: file is 3 in course.toml, and a path in exercises is expected',
        'course: 3 has no title in course.toml',
        "course: 3: points is '12' in course.toml, and a whole number is expected",
        'course: the exercise number 2 has no file in course.toml',
        'course: the exercise number 2: points is True in course.toml, and a whole number is expected',
        "course: the exercise number 2: hints is 'no' in course.toml, and a list of strings is expected",
    ]


@pytest.mark.parametrize(
    ('text', 'said'),
    [
        ('[[exercise', 'cannot be read'),
        ('exercise = 3', 'has no exercises: write [[exercise]]'),
        ('', 'has no exercises: write [[exercise]]'),
    ],
)
def test_a_manifest_that_is_none_is_a_problem_and_no_traceback(
    copy: Path, capsys: pytest.CaptureFixture[str], text: str, said: str
) -> None:
    (copy / 'exercises' / 'course.toml').write_text(text)
    assert main([str(copy), '--quick']) == 1
    (line,) = capsys.readouterr().out.splitlines()
    assert said in line


def test_a_problem_of_one_exercise_hides_none_of_another(copy: Path) -> None:
    shutil.rmtree(copy / 'solutions' / 'two_seas')
    edit(copy / 'exercises' / 'course.toml', 'title = "A black box"', 'title = "A red box"')
    found = problems(copy)
    assert any('black_box is called' in problem for problem in found)
    assert any('two_seas' in problem and 'does not exist' in problem for problem in found)


def test_the_program_says_what_it_takes(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(['--help'])
    assert end.value.code == 0
    assert '--quick' in capsys.readouterr().out


@pytest.mark.processes
def test_everything_is_listed_at_once_and_a_rubric_that_exits_ends_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from edulaunch.course.copying import new_course

    folder = tmp_path / 'course'
    new_course(str(folder))
    (folder / 'rubrics' / 'odd.py').write_text('raise SystemExit(3)')
    with open(folder / 'course.toml', 'a') as file:
        file.write("\n[[exercise]]\nfile = 'odd.launch.py'\ntitle = 'Odd'\npoints = 3\n")
    edit(folder / 'solutions' / 'spin.launch.py', "'-r', '10'", "'-r', '1'")
    assert main([str(folder)]) == 1
    told = capsys.readouterr().out
    assert 'course: a file of the course ended the check: SystemExit: 3\n' in told
    assert 'course: odd needs 3 hints' in told
    assert 'spin.launch.py: some failed: ' in told


def test_each_mistake_of_a_rubric_is_a_problem_with_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rubric = _new_course(tmp_path) / 'rubrics' / 'spin.yaml'
    edit(rubric, 'points: 1', 'points: one')
    edit(rubric, 'rate: 10', 'rat: 10')
    assert main([str(tmp_path / 'course'), '--quick']) == 1
    assert capsys.readouterr().out.splitlines() == [
        f"course: {rubric}:11: 'one' points; points are whole numbers, and never negative",
        f'course: {rubric}:13: topic has no rat; did you mean rate?',
    ]


def test_two_rubrics_of_one_exercise_are_found(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (_new_course(tmp_path) / 'rubrics' / 'spin.py').write_text('')
    assert main([str(tmp_path / 'course'), '--quick']) == 1
    assert capsys.readouterr().out == (
        'course: spin has several rubrics, spin.py and spin.yaml, and spin.yaml counts: remove the other one\n'
    )


@pytest.mark.parametrize(
    ('old', 'new', 'said'),
    [
        (
            "'spin.launch.py'",
            "'../spin.launch.py'",
            "file is '../spin.launch.py' in course.toml, and a path in exercises is expected",
        ),
        ("'spin.launch.py'", "'/spin.launch.py'", 'a path in exercises is expected'),
        ("'spin.launch.py'", "''", 'a path in exercises is expected'),
        ('title =', 'titel =', 'spin.launch.py has the unknown field titel in course.toml; did you mean title?'),
        (
            'points = 6',
            'points = 6\nvariants = [1.0]',
            'variants is [1.0] in course.toml, and a list of lists of strings is expected',
        ),
        (
            'points = 6',
            'points = 6\nvariants = [[]]',
            'variants is [[]] in course.toml, and a list of lists of strings is expected',
        ),
    ],
)
def test_a_field_of_the_manifest_that_cannot_mean_anything_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, said: str
) -> None:
    edit(_new_course(tmp_path) / 'course.toml', old, new)
    assert main([str(tmp_path / 'course'), '--quick']) == 1
    assert said in capsys.readouterr().out


def test_a_starter_file_that_gets_no_mark_of_its_variant_is_found(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    course = _new_course(tmp_path)
    edit(course / 'course.toml', 'points = 6', "points = 6\nvariants = [['turtle1', 'turtle2']]")
    assert main([str(course), '--quick']) == 0
    edit(course / 'exercises' / 'spin.launch.py', 'Grade it with', 'Grade with')
    capsys.readouterr()
    assert main([str(course), '--quick']) == 1
    said = capsys.readouterr().out
    assert said.startswith('course: exercises/spin.launch.py needs a line that begins with "Grade it ", because'), said


def _new_course(folder: Path) -> Path:
    from edulaunch.course.copying import new_course

    new_course(str(folder / 'course'))
    return folder / 'course'

"""Personal variants: the same for a student on every machine, seen in the task, asked for by the rubric, known from another's.

Runs that a secret chooses: the same for the same student and text, others for all others.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from edugrade.cli import main
from edugrade.course import read_course
from edugrade.grading import plan_work
from edugrade.submission import Submission
from edugrade.variant import CourseSecret, Variant, personal, variant_for, write_variants

from edulaunch.desk.cli.main import main as edulaunch
from edulaunch.errors import UnusableInput

ROOT = Path(__file__).resolve().parents[2]
COURSE = {item.name: item for item in read_course(str(ROOT / 'exercises' / 'course.toml'))}
KEY = 'a secret of sixteen bytes and more'
EXPECTED = [('8f4edc98', {'1.0': '1.4', '0.4': '0.4'}), ('e2063d97', {'night': 'cellar', 'day': 'day', '40': '30'})]


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    path = tmp_path / 'secret'
    path.write_text(KEY)
    return path


def test_words_and_numbers_are_replaced_whole_and_all_at_once() -> None:
    variant = Variant('ada', '00000000', {'first': 'second', 'second': 'first', '0.1': '0.2', '1.0': '1.5'})
    text = "first, second's first_one; 0.1 m, 10.1 m, 0.15, x=1.0, 1.0.3; at 0.1."
    assert variant.of(text) == "second, first's first_one; 0.2 m, 10.1 m, 0.15, x=1.5, 1.0.3; at 0.2."


def test_the_same_on_every_machine_and_every_python() -> None:
    found = [personal(COURSE[name], 'ada', CourseSecret.of(KEY.encode())) for name in ('tower', 'fence')]
    assert [(each.tag, dict(each.values)) for each in found if each] == EXPECTED


def test_at_least_twelve_exercises_have_variants_and_students_differ() -> None:
    key = CourseSecret.of(KEY.encode())
    own = [item for item in COURSE.values() if item.variants]
    assert len(own) >= 12
    for item in own:
        made = {json.dumps(found.values) for n in range(30) if (found := personal(item, f'student{n}', key))}
        assert len(made) > 1, item.name


@pytest.mark.processes
def test_a_copy_for_a_student_names_the_values_in_the_task_and_is_graded_by_them(
    tmp_path: Path, secret: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    copy = tmp_path / 'carl'
    assert edulaunch(['course', 'copy', str(copy), '--student', 'carl', '--course-secret-file', str(secret)]) == 0
    variant = personal(COURSE['two_rooms'], 'carl', CourseSecret(str(secret)))
    assert variant is not None and variant.values['hall'] != 'hall'
    stub = (copy / 'exercises' / 'two_rooms.launch.py').read_text()
    assert (
        f'Variant {variant.tag}, made for carl.' in stub and f'/{variant.values["hall"]}/talker' in stub and ' hall' not in stub
    )
    solution = (ROOT / 'solutions' / 'two_rooms.launch.py').read_text()
    (copy / 'exercises' / 'two_rooms.launch.py').write_text(variant.stub(solution))
    monkeypatch.chdir(copy)
    assert main(['exercises/two_rooms.launch.py', '--json', str(tmp_path / 'report.json'), '--sandbox', 'off']) == 0
    assert json.loads((tmp_path / 'report.json').read_text())['variant'] == {
        'student': 'carl',
        'tag': variant.tag,
        'values': dict(variant.values),
    }
    assert main(['exercises/two_rooms.launch.py', '--hint', '3']) == 0
    assert f'/{variant.values["hall"]}/' in capsys.readouterr().out
    words = ['--submission', 'exercises/two_rooms.launch.py', '--sandbox', 'off']
    assert main(['verify', '../report.json', *words]) == 0
    report = json.loads((tmp_path / 'report.json').read_text())
    report['variant']['values']['hall'] = 'nowhere'
    (tmp_path / 'forged.json').write_text(json.dumps(report))
    capsys.readouterr()
    assert main(['verify', '../forged.json', *words]) == 1
    assert 'variant: not the one that the course gives this student' in capsys.readouterr().out
    monkeypatch.chdir(tmp_path)
    assert main(['verify', 'report.json', '--submission', 'carl/exercises/two_rooms.launch.py', '--sandbox', 'off']) == 2
    assert 'nothing here says whose values are whose' in capsys.readouterr().err


@pytest.mark.processes
def test_a_class_is_graded_by_the_variant_of_each_and_told_of_another_one_s(
    tmp_path: Path, secret: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (ROOT / 'solutions' / 'tower.launch.py').read_text().replace('"""\nfrom', 'Grade it with `edugrade`\n"""\nfrom')
    ada, bert = (personal(COURSE['tower'], name, CourseSecret(str(secret))) for name in ('ada', 'bert'))
    assert ada is not None and bert is not None and ada.values != bert.values
    for student, handed_in in (('ada', ada.stub(text)), ('bert', bert.stub(text)), ('carl', ada.stub(text))):
        (tmp_path / 'class' / student).mkdir(parents=True)
        (tmp_path / 'class' / student / 'tower.launch.py').write_text(handed_in)
    words = ['batch', str(tmp_path / 'class'), '--personal', '--sandbox', 'off']
    assert main(words) == 2 and '--course-secret-file FILE' in capsys.readouterr().err
    words += ['--csv', str(tmp_path / 'marks.csv')]
    assert main([*words, '--course-secret-file', str(secret)]) == 3  # somebody has to look at one of them
    results = {
        name: json.loads((tmp_path / 'class.results' / name / 'tower.launch.py.json').read_text())
        for name in ('ada', 'bert', 'carl')
    }
    assert [results[name]['verdict'] for name in ('ada', 'bert')] == ['all passed', 'all passed']
    told = [check['reason'] for check in results['carl']['checks'] if check['name'] == 'own_variant']
    assert told == ["this is another student's variant, which gets no mark until a teacher has looked at it"]
    assert results['carl']['points']['earned'] is None
    assert all(check['name'] != 'own_variant' for check in results['ada']['checks'])
    assert 'carl,,carl/tower.launch.py,tower,not graded,,' in (tmp_path / 'marks.csv').read_text()  # the grader did not break


def test_nothing_is_read_from_what_is_handed_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'handed_in').mkdir()
    (tmp_path / 'handed_in' / 'course.toml').write_text('exercise = []')
    (tmp_path / 'handed_in' / 'my_variant.toml').write_bytes(
        write_variants('ada', {'tower': Variant('ada', '1', {'0.4': '0.3'})})
    )
    monkeypatch.chdir(tmp_path)
    assert variant_for('tower', '', None) is None
    monkeypatch.chdir(tmp_path / 'handed_in')
    assert variant_for('tower', '', None) == Variant('ada', '1', {'0.4': '0.3'})


def test_a_copy_without_a_secret_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert edulaunch(['course', 'copy', str(tmp_path / 'ada'), '--student', 'ada']) == 2
    assert '--course-secret-file FILE' in capsys.readouterr().err and not (tmp_path / 'ada').exists()


CIRCLE = Path(__file__).parents[2] / 'solutions' / 'circle.launch.py'


def test_a_secret_that_everybody_can_change_is_refused(tmp_path: Path) -> None:
    file = tmp_path / 'secret'
    file.write_text('0123456789abcdef')
    file.chmod(0o666)
    with pytest.raises(UnusableInput, match='every user of this computer can change the course secret'):
        CourseSecret(str(file))
    file.chmod(0o600)
    CourseSecret(str(file))


@pytest.fixture
def chosen_by(tmp_path: Path) -> CourseSecret:
    (tmp_path / 'secret').write_text('0123456789abcdef\n')
    return CourseSecret(str(tmp_path / 'secret'))


def test_student_text_exercise_and_secret_choose(chosen_by: CourseSecret, tmp_path: Path) -> None:
    (tmp_path / 'other').write_text('0123456789abcdeX')
    seeds = [
        chosen_by.seed('circle', 'anna', 'f00d'),
        chosen_by.seed('circle', 'bert', 'f00d'),
        chosen_by.seed('circle', 'anna', 'beef'),
        chosen_by.seed('follow', 'anna', 'f00d'),
        CourseSecret(str(tmp_path / 'other')).seed('circle', 'anna', 'f00d'),
    ]
    assert len(set(seeds)) == 5
    assert chosen_by.seed('circle', 'anna', 'f00d') == seeds[0]


def test_the_runs_follow(chosen_by: CourseSecret) -> None:
    anna, bert = (plan_work(Submission(str(CIRCLE)), secret=chosen_by, student=name) for name in ('anna', 'bert'))
    assert anna.secret == chosen_by.name and '0123' not in chosen_by.name
    assert [run.arguments for run in anna.scenarios] != [run.arguments for run in bert.scenarios]
    assert len({run.seed for run in (*anna.scenarios, *bert.scenarios)}) == 4


@pytest.mark.parametrize('text', ['', 'short', None])
def test_what_is_no_secret_is_an_error(tmp_path: Path, text: str | None) -> None:
    if text is not None:
        (tmp_path / 'secret').write_text(text)
    with pytest.raises(UnusableInput, match='course secret'):
        CourseSecret(str(tmp_path / 'secret'))

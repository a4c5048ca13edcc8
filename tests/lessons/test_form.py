"""The form that all lessons share."""

from __future__ import annotations

import ast
import re
import statistics

import pytest
import yaml

from edulaunch.canvas.picture import SCENE_TYPE
from tests.lessons.doing import minutes, ready_made, stated_minutes, steps
from tests.lessons.notebook import LESSONS, ORDER, Cell, Lesson

FIRST_USES = {
    '01_first_launch': [
        'launch file',
        'package',
        'recording',
        'node',
        'namespace',
        'launch actions',
        'topics',
        'publishes',
        'subscribe',
        'message',
        'parameter',
        'launch argument',
        'remapping',
        'includes',
    ],
    '04_conditions': ['condition'],
    '08_static_broadcaster': [
        'frame',
        'transform',
        'tf tree',
        'roll',
        'pitch',
        'yaw',
        'quaternion',
        'workspace',
        'entry points',
        'spin',
        'broadcaster',
        'static',
    ],
    '09_broadcaster_and_listener': ['callback', 'service', 'client', 'future', 'timer'],
    '13_large_project': ['bringup', 'wildcard', 'environment variable'],
}
SCREEN = 40
"""Lines."""
ON_PURPOSE = ['nbval-ignore-output', 'raises-exception']
PATHS_AND_SUCH = re.compile(
    r'(?<![\w.])/(home|root|tmp|work|Users|usr|opt|mnt|var)/|\b0x[0-9a-f]{6,}|site-packages|ipykernel|\d ms\b'
)


def written(lesson: Lesson) -> list[Cell]:
    return [cell for cell in lesson.code if cell.file is not None]


def test_the_lessons_are_these() -> None:
    assert sorted(path.stem for path in LESSONS.glob('*.ipynb')) == ORDER


def test_a_kernel_is_named_so_that_jupyter_does_not_ask(lesson: Lesson) -> None:
    assert lesson.raw['metadata'] == {
        'kernelspec': {'display_name': 'Python 3 (ipykernel)', 'language': 'python', 'name': 'python3'},
        'language_info': {'name': 'python'},
    }


def test_cell_ids_are_words_that_stay(lesson: Lesson) -> None:
    ids = [cell.id for cell in lesson.cells]
    assert len(set(ids)) == len(ids)
    assert all(re.fullmatch(r'[a-z][a-z0-9]*(-[a-z0-9]+)*', ident) for ident in ids)


def test_a_lesson_is_short(lesson: Lesson) -> None:
    assert len(lesson.cells) <= 80
    assert max(len(cell.lines) - (cell.file is not None) for cell in lesson.code) <= 25
    assert statistics.median(len(cell.lines) for cell in lesson.code if cell.file is None) <= 5


def test_no_more_than_three_cells_in_a_row_are_only_to_be_run(lesson: Lesson) -> None:
    assert [row for row in ready_made(lesson) if len(row) > 3] == []


def test_the_minutes_are_those_of_the_text_and_the_work(lesson: Lesson) -> None:
    assert 0.75 * minutes(lesson) <= stated_minutes(lesson) <= 1.25 * minutes(lesson)


def test_a_student_predicts_answers_and_writes(lesson: Lesson) -> None:
    kinds = [step.kind for step in steps(lesson)]
    enough = kinds.count('predict') >= 3 and kinds.count('quiz') >= 2 and kinds.count('write') + kinds.count('turn') >= 2
    assert enough, kinds


def test_each_prediction_is_compared_or_answered(lesson: Lesson) -> None:
    code = '\n'.join(cell.source for cell in lesson.code)
    asked = set(re.findall(r"predict\('([\w-]+)'", code))
    answered = set(re.findall(r"compare\('([\w-]+)'", code))
    assert asked == answered


def test_each_lesson_asks_something_of_an_earlier_one(lesson: Lesson) -> None:
    told = re.findall(r'Back to lesson (\d+): ', '\n'.join(cell.text for cell in lesson.code))
    assert all(int(number) < int(lesson.name[:2]) for number in told)
    assert told or lesson.name < '02_'


def test_an_output_fits_on_a_screen(lesson: Lesson) -> None:
    long = [cell.id for cell in lesson.code if cell.text.count('\n') >= SCREEN and not cell.id.startswith('check')]
    assert long == [], 'a report of an exercise is as long as it has to be, and its end says what to do next'


def test_no_lines_run_off_the_page(lesson: Lesson) -> None:
    for cell in lesson.code:
        assert max(map(len, cell.lines)) <= 120, cell.id


def test_nothing_is_given_away_and_all_outputs_are_kept_beside_it(lesson: Lesson) -> None:
    code = [row for row in lesson.raw['cells'] if row['cell_type'] == 'code']
    assert all((row['outputs'], row['execution_count']) == ([], None) for row in code)
    assert all(set(row['metadata']) <= {'tags'} for row in lesson.raw['cells'])
    assert list(lesson.kept) == [cell.id for cell in lesson.code]


def test_a_cell_has_one_output_and_no_error_but_on_purpose(lesson: Lesson) -> None:
    for cell in lesson.code:
        kinds = [output['output_type'] for output in cell.outputs]
        if cell.tags == ON_PURPOSE:
            assert kinds[-1:] == ['error'], cell.id
        else:
            assert 'error' not in kinds, cell.id
            names = [output.get('name', kind) for kind, output in zip(kinds, cell.outputs, strict=True)]
            assert len(set(names)) == len(names) and set(names) <= {'stdout', 'stderr', 'execute_result', 'display_data'}, cell.id


def test_a_mistake_on_purpose_shows_no_traceback(lesson: Lesson) -> None:
    for cell in lesson.code:
        for output in cell.outputs:
            if output['output_type'] == 'error' and lesson.name != '00_python':  # that one shows Python's own
                assert 'help: ' in output['traceback'][-1], cell.id
                assert 'Traceback' not in '\n'.join(output['traceback']), cell.id


def test_a_picture_says_in_text_what_it_shows(lesson: Lesson) -> None:
    pictures = [output for cell in lesson.code for output in cell.outputs if 'image/png' in output.get('data', {})]
    for output in pictures:
        caption = ''.join(output['data']['text/plain'])
        assert len(caption) > 20 and 'scene' not in caption
        assert output['metadata']['image/png']['alt'] == caption
        assert re.fullmatch('[0-9a-f]{8}', output['data'][SCENE_TYPE]['digest'])


def test_outputs_are_equal_on_every_machine(lesson: Lesson) -> None:
    for cell in lesson.code:
        assert cell.tags or not PATHS_AND_SUCH.search(cell.text), cell.id


def test_only_writing_a_file_and_failing_on_purpose_are_not_compared(lesson: Lesson) -> None:
    for cell in lesson.code:
        assert cell.tags in (
            (['nbval-ignore-output'],) if cell.file is not None else ([], ['nbval-ignore-output'], ON_PURPOSE)
        ), cell.id
    assert sum(cell.tags == ['nbval-ignore-output'] and cell.file is None for cell in lesson.code) <= 5, (
        'messages with paths only'
    )
    assert sum(cell.tags == ON_PURPOSE for cell in lesson.code) <= 3


def test_files_are_written_only_where_git_does_not_look(lesson: Lesson) -> None:
    assert all(path.startswith(('my_launch/', 'my_ws/src/')) for path in lesson.files())


def test_every_written_file_can_be_read(lesson: Lesson) -> None:
    for cell in written(lesson):
        path, text = cell.file or ('', '')
        if path.endswith('oops.launch.py') and lesson.name == '00_python':
            continue  # its mistake is the point
        if path.endswith('.py'):
            ast.parse(text, path)
        elif path.endswith('.yaml'):
            yaml.safe_load(text)


@pytest.mark.parametrize(
    'part',
    [
        r'^# \d+\. ',
        r'After this lesson \(about (20|25|30|35|40|45) minutes\) you can\n\n- ',
        r'\*\*Predict',
        r'\*\*Explain',
        r'^## \d+\.\d+ Your turn$',
        r'hen something is wrong',
        r'^## On a real robot$',
        r'^## What this lesson leaves out\n\n- ',
    ],
)
def test_a_lesson_has_every_part(lesson: Lesson, part: str) -> None:
    assert re.search(part, lesson.prose, re.MULTILINE)


def test_parts_are_numbered_in_order(lesson: Lesson) -> None:
    number = str(int(lesson.name[:2]))
    headings = re.findall(r'^## (\d+)\.(\d+) ', lesson.prose, re.MULTILINE)
    assert headings == [(number, str(index + 1)) for index in range(len(headings))]


def test_hints_have_three_levels_and_say_something(lesson: Lesson) -> None:
    prose = lesson['your-turn-hints'].source
    hints = re.findall(r'<details><summary>Hint (\d): ([^<]+)</summary>(.*?)</details>', prose, re.DOTALL)
    assert [(number, title) for number, title, _ in hints] == [
        ('1', 'a question'),
        ('2', 'where to look'),
        ('3', 'almost the answer'),
    ]
    assert all(len(text.split()) >= 8 for _, _, text in hints)


def test_the_shipped_turn_says_what_is_missing(lesson: Lesson) -> None:
    told = lesson['your-turn-check'].text
    assert 'some failed' in told or 'unusable input' in told or 'does not exist' in told


def test_every_exercise_of_a_lesson_is_checked_in_it(lesson: Lesson) -> None:
    course = (LESSONS.parent / 'exercises' / 'course.toml').read_text(encoding='utf-8')
    mine = re.findall(r"file = '(?:.*/)?(\w+)\.launch\.\w+'\ntitle = .*\nlesson = '" + lesson.name + "'", course)
    assert mine == re.findall(r"^check\('(\w+)'\)$", '\n'.join(cell.source for cell in lesson.code), re.MULTILINE)


@pytest.mark.parametrize(('name', 'term'), [(name, term) for name, terms in FIRST_USES.items() for term in terms])
def test_a_term_stands_out_where_it_is_explained(name: str, term: str) -> None:
    prose = Lesson(name).prose
    assert re.search(rf'\*{{1,2}}{term}\w*\*{{1,2}}', prose, re.IGNORECASE), f'{term} is never in italics in {name}'


@pytest.mark.parametrize(
    ('checkpoint', 'lessons'),
    [('after_lesson_8', ['08_static_broadcaster']), ('after_lesson_9', ['08_static_broadcaster', '09_broadcaster_and_listener'])],
)
def test_a_checkpoint_is_what_the_lessons_before_write(checkpoint: str, lessons: list[str]) -> None:
    inside = 'my_ws/src/learning_tf2_py/'
    expected = {'learning_tf2_py/__init__.py': '', 'resource/learning_tf2_py': ''}
    for name in lessons:
        expected.update({path.removeprefix(inside): text for path, text in Lesson(name).files().items()})
    root = LESSONS / 'checkpoints' / checkpoint
    assert {
        str(path.relative_to(root)): path.read_text(encoding='utf-8') for path in root.rglob('*') if path.is_file()
    } == expected


def test_what_says_done_has_just_run_the_file(lesson: Lesson) -> None:
    """A recording of before the last change, or of before a mistake, would be judged otherwise."""
    for cell in lesson.code:
        if "'done'" in cell.source and re.search(r'\.(nodes|logs|parameters|topics)\b', cell.source):
            assert re.search(r'edulaunch\.run\(', cell.source), cell.id

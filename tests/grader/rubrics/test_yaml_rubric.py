"""A YAML rubric is read, or refused with the line that is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.cli import main
from edugrade.rubric import RubricMistake
from edugrade.rubrics.catalogue import find_rubric
from edugrade.rubrics.yaml_rubric import read_yaml_rubric

GOOD = """title: A
runs:
  - name: one
    arguments: {speed: {between: [1, 2], decimals: 1}, goal: {one_of: [a, b]}, flag: true, text: '007'}
    duration: {between: [3, 4], decimals: 0}
checks:
  - alive: {}
    name: lives
  - travels: {turtle: turtle1, at_least: 2 * $(arg speed)}
    points: 2
    needs: [lives]
"""


def test_runs_are_chosen_by_the_seed() -> None:
    rubric = read_yaml_rubric('a.yaml', GOOD.encode())
    runs = [rubric.scenarios(seed)[0] for seed in range(20)]
    assert rubric.scenarios(3) == rubric.scenarios(3)
    assert {len(run.arguments['speed']) for run in runs} == {3}
    assert {run.arguments['goal'] for run in runs} == {'a', 'b'}
    assert {(run.arguments['flag'], run.arguments['text']) for run in runs} == {('true', '007')}
    assert {run.duration_s for run in runs} == {3.0, 4.0}


def test_checks_have_names_sentences_and_needs() -> None:
    lives, travels = read_yaml_rubric('a.yaml', GOOD.encode()).checks
    assert (lives.name, lives.sentence, lives.points) == ('lives', 'No node dies before the end', 0)
    assert (travels.name, travels.sentence, travels.needs) == ('travels_2', 'turtle1 drives at least 2 * speed m', (lives,))


MISTAKES = {
    '': ('1: the file is empty', ''),
    'title: A\nruns: [\n': ('3: ', ''),
    'a list': ('1: a rubric is written as', '- a'),
    'no runs': ('1: the rubric lacks runs', GOOD.replace('runs:', 'title:', 1).replace('title: A\n', '', 1)),
    'misspelt': ('6: a rubric has no chekcs; did you mean checks?', GOOD.replace('checks', 'chekcs')),
    'a kind that is none': ('7: a check has no alve; did you mean alive?', GOOD.replace('alive', 'alve')),
    'no kind': ('7: a check is one of', GOOD.replace('alive: {}', 'points: 1')),
    'a field that is none': ('9: travels has no turtel; did you mean turtle?', GOOD.replace('turtle:', 'turtel:')),
    'a field that lacks': ('9: travels lacks at_least', GOOD.replace(', at_least: 2 * $(arg speed)', '')),
    'an argument that no run has': ('9: the run one has no argument sped', GOOD.replace('(arg speed)', '(arg sped)')),
    'a need that is none': ('11: travels_2 needs live, which is not before it', GOOD.replace('[lives]', '[live]')),
    'points': ('10: -2 points', GOOD.replace('points: 2', 'points: -2')),
    'a run without a name': ("3: name is ''; write a string", GOOD.replace('name: one', "name: ''")),
    'a name that is no text': ('8: name is []; write a string', GOOD.replace('name: lives', 'name: []')),
    'advice without words': ('11: try is None; write a string', GOOD.replace('needs: [lives]', 'try: null')),
    'a range': ('4: a choice is', GOOD.replace('[1, 2]', '[2, 1]')),
    'no choice': ('4: one_of is a list', GOOD.replace('[a, b]', '[]')),
    'a duration': ('3: the scenario one lasts -1', GOOD.replace('{between: [3, 4], decimals: 0}', '-1')),
    'a duration that is a word': ("5: 'long' is not a number", GOOD.replace('{between: [3, 4], decimals: 0}', 'long')),
    'twice': ('2: title is there twice', 'title: A\n' + GOOD),
    'an object': ('1: ', GOOD.replace('title: A', 'title: !!python/name:os.system a')),
    'a pattern': (
        '7: pattern is not a valid regular expression',
        GOOD.replace('alive: {}', 'prints: {package: a, executable: b, pattern: "("}'),
    ),
    'a sum that is none': ('9: at_least is', GOOD.replace('2 * $(arg speed)', '2 ** $(arg speed)')),
    'a tolerance': ("7: tolerance is 'x'", GOOD.replace('alive: {}', 'circle: {radius: 1, tolerance: x}')),
}


@pytest.mark.parametrize('name', MISTAKES)
def test_a_mistake_names_its_line(name: str) -> None:
    words, text = MISTAKES[name]
    with pytest.raises(RubricMistake) as caught:
        read_yaml_rubric('a.yaml', (text or (name if ':' in name else '')).encode())
    assert str(caught.value).startswith(f'a.yaml:{words}'), caught.value


BROKEN = {
    'def (': '1: ',
    '\nx = 1 / 0': '2: ZeroDivisionError: division by zero',
    'from edugrade import check\n\n@check(points=1)\ndef a(run):\n    pass': '3: ValueError: the check a() has no docstring',
    'from edugrade import *\nRUBRIC = Rubric(title="a", scenarios=lambda r: [], checks=[print])': '2: TypeError: ',
    'from edugrade import *\n\nRUBRIC = Rubric(title="a", scenarios=lambda r: [], checks=[])': '3: scenarios(random) must return',
    'from edugrade import *\nRUBRIC = Rubric(title="a", scenarios=lambda r: [Scenario("a", {"x": 1})], checks=[])': '2: the scenario a lasts',
}


@pytest.mark.parametrize('text', BROKEN)
def test_a_mistake_in_python_names_its_line_too(tmp_path: Path, text: str) -> None:
    (tmp_path / 'a.py').write_text(text)
    with pytest.raises(RubricMistake) as caught:
        find_rubric('a', str(tmp_path / 'a.py'))[1].scenarios(1)
    assert str(caught.value).startswith(f'{tmp_path}/a.py:{BROKEN[text]}'), caught.value


def test_the_command_says_it_and_gives_no_mark(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'a.yaml').write_text('title: 1')
    (tmp_path / 'a.launch.py').write_text('')
    assert main([str(tmp_path / 'a.launch.py'), '--rubric', str(tmp_path / 'a.yaml')]) == 3
    assert capsys.readouterr().err == f'edugrade: the rubric is wrong: {tmp_path}/a.yaml:1: the rubric lacks runs and checks\n'


def test_whole_bounds_without_decimals_give_whole_numbers() -> None:
    text = """title: A
runs:
  - {name: one, arguments: {count: {between: [1, 5]}, speed: {between: [1.0, 5]}, exact: {between: [1, 5], decimals: 1}}}
checks: [{alive: {}}]
"""
    found = [read_yaml_rubric('a.yaml', text.encode()).scenarios(seed)[0].arguments for seed in range(20)]
    assert {each['count'] for each in found} == {'1', '2', '3', '4', '5'}
    assert all(len(each['speed']) == 4 and len(each['exact']) == 3 for each in found)


def test_a_name_can_be_made_up_for_each_submission() -> None:
    text = 'title: A\nruns: [{name: one, arguments: {room: {word: 3}}}]\nchecks: [{alive: {}}]\n'
    rubric = read_yaml_rubric('a.yaml', text.encode())
    found = {rubric.scenarios(seed)[0].arguments['room'] for seed in range(50)}
    assert len(found) > 45 and all(len(name) == 6 and name.isalpha() and name.islower() for name in found)
    with pytest.raises(RubricMistake, match='a.yaml:2: word is a number of syllables from 2 to 6'):
        read_yaml_rubric('a.yaml', text.replace('3', '99').encode())


def test_all_runs_and_checks_with_a_mistake_are_named_at_once() -> None:
    text = (
        GOOD.replace('decimals: 1', 'decimals: 9').replace('  - alive: {}', '  - alife: {}').replace('points: 2', 'points: true')
    )
    with pytest.raises(RubricMistake) as raised:
        read_yaml_rubric('a.yaml', text.encode())
    assert str(raised.value).splitlines() == [
        'a.yaml:4: decimals is a whole number from 0 to 6',
        'a.yaml:7: a check has no alife; did you mean alive?',
        'a.yaml:10: True points; points are whole numbers, and never negative',
    ]


def test_a_check_that_needs_a_broken_one_is_no_second_mistake() -> None:
    with pytest.raises(RubricMistake) as raised:
        read_yaml_rubric('a.yaml', GOOD.replace('alive: {}', 'alive: {always: 3}').encode())
    assert len(str(raised.value).splitlines()) == 1

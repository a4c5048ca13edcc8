"""What the rules find stands as marks on the live view and the replay."""

from __future__ import annotations

import pytest

import edulaunch
from edulaunch.advice.reader import reader_of
from edulaunch.advice.rendering import (
    _listed,
    diagnosis,
    diagnosis_data,
    help_below,
    help_of,
    help_of_facts,
    rendered,
    warning_lines,
)
from edulaunch.advice.rule import Finding, rule_named
from edulaunch.desk.view.replay import timeline_of
from tests.advice.harness import EXAMPLES


def test_a_finding_is_a_mark_on_its_node_without_a_path_of_this_machine() -> None:
    recording = edulaunch.run(EXAMPLES / 'programs.same-name' / 'failing.launch.py', duration_s=1.0, console=lambda *_: None)
    (mark,) = timeline_of(recording)['advice']
    assert (mark['rule'], mark['subject'], mark['time']) == ('programs.same-name', {'node': '/talker'}, 0)
    assert mark['text'].startswith('two nodes have the name /talker') and '(failing.launch.py:9, at 0.00 s)' in mark['text']
    assert '/talker_2' not in mark['text'] and str(EXAMPLES) not in mark['text']


def test_what_is_about_a_program_stands_at_its_node() -> None:
    file = EXAMPLES / 'programs.died' / 'failing.py'
    recording = edulaunch.run(EXAMPLES / 'program.launch.py', arguments={'file': file}, console=lambda *_: None)
    assert [mark['subject'] for mark in timeline_of(recording)['advice']] == [{'node': '/counter'}]


def test_a_healthy_run_has_no_marks() -> None:
    recording = edulaunch.run(EXAMPLES / 'programs.same-name' / 'healthy.launch.py', duration_s=1.0, console=lambda *_: None)
    assert timeline_of(recording)['advice'] == []


READER = reader_of({}, '')
GIVEN = Finding('topic', '/chatter', {}, rule='messages.nobody-listens', process='talker-1', file='/w/a.py', line=3, time_s=1.5)


def test_a_finding_has_its_program_its_place_and_its_time() -> None:
    words = rendered(GIVEN, READER)
    assert words.where.split(', ')[0] == 'talker-1' and words.where.endswith('a.py:3, at 1.50 s')
    assert str(words) == f'{words.what} ({words.where})\n  help: {words.do}'
    bare = rendered(Finding('topic', '/chatter', {}, rule='messages.nobody-listens'), READER)
    assert bare.where == '' and str(bare) == f'{bare.what}\n  help: {bare.do}'


@pytest.mark.parametrize(
    ('count', 'shown_by', 'last'), [(5, 'x', None), (6, '', 'and 1 more'), (8, 'x', 'and 3 more; show all of them with x')]
)
def test_a_run_ends_with_at_most_five_findings(count: int, shown_by: str, last: str | None) -> None:
    lines = warning_lines([GIVEN] * count, READER, shown_by)
    assert lines[:5] == [f'{rendered(GIVEN, READER).sign}: {rendered(GIVEN, READER)}'] * 5
    assert lines[5:] == ([] if last is None else [last])
    assert len(warning_lines([GIVEN] * 3, READER, most=1)) == 2


def test_a_diagnosis_for_people_is_numbered_and_its_labels_line_up() -> None:
    assert list(diagnosis([], READER)) == ['no problems found']
    words = rendered(GIVEN, READER)
    shown = list(diagnosis([GIVEN, GIVEN], READER))
    half = len(shown) // 2
    assert shown[0] == f'1. {words.what}' and shown[half] == f'2. {words.what}'
    assert shown[1] == f'   where: {words.where}'
    assert f'   do:    {words.do}' in shown
    assert [line.split(':')[0].strip() for line in shown[1:half]] == [
        'where',
        *(['why'] if words.why else []),
        'do',
        *(['see'] if words.lesson else []),
    ]


def test_a_diagnosis_as_data_has_facts_and_sentences() -> None:
    words, rule = rendered(GIVEN, READER), rule_named(GIVEN.rule)
    assert diagnosis_data([GIVEN], READER) == {
        'format': 1,
        'findings': [
            {
                'rule': GIVEN.rule,
                'level': rule.level,
                'confidence': rule.confidence,
                'kind': 'topic',
                'name': '/chatter',
                'facts': {},
                'file': '/w/a.py',
                'line': 3,
                'time_s': 1.5,
                'process': 'talker-1',
                'what': words.what,
                'why': words.why or None,
                'do': words.do,
                'lesson': words.lesson,
            }
        ],
    }


def test_help_below_an_error_of_a_launch_file_names_its_place() -> None:
    error = {'type': 'X', 'message': 'odd', 'facts': {}, 'place': ('a.launch.py', 3)}
    assert help_below(error, {}) == 'a.launch.py:3'
    assert help_below({**error, 'facts': {'action': 'Node'}}, {}) == 'a.launch.py:3 (Node)'
    assert help_below({**error, 'process': 'talker-1'}, {}) is None
    assert help_below({**error, 'place': None}, {}) is help_of(error) is None
    assert help_of_facts({}) == ''


def test_a_known_error_has_one_line_of_help() -> None:
    facts = {'about': 'messages.field', 'type': 'Point', 'field': 'xx', 'near': 'x', 'fields': ['x', 'y', 'z']}
    error = {'type': 'AssertionError', 'message': 'Invalid arguments', 'facts': facts, 'place': ('a.py', 3)}
    words = help_of(error)
    assert words is not None and 'xx' in words and words == help_of_facts(facts)
    assert help_below({**error, 'process': 'talker-1'}, {}) == words
    assert help_below(error, {}) == f'a.py:3: {words}'


def test_long_lists_of_names_are_cut() -> None:
    assert _listed([str(number) for number in range(12)], READER) == ', '.join(map(str, range(12)))
    assert _listed(tuple(range(13)), READER) == ', '.join([*map(str, range(12)), '...'])
    assert (_listed(3, READER), _listed('/a', READER)) == (3, '/a')

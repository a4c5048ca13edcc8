"""What the rules find stands as marks on the live view and the replay."""

from __future__ import annotations

import edulaunch
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

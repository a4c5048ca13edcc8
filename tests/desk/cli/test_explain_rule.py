"""`edulaunch explain RULE`."""

from __future__ import annotations

import pytest

from edulaunch.advice.rule import all_rules
from edulaunch.desk.cli.explain_rule import is_rule
from edulaunch.desk.cli.main import main


def test_a_rule_is_explained_with_cause_example_and_cure(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['explain', 'time.timer-period']) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[:4] == [
        'time.timer-period (warning)',
        '  what:   the timer of <callback>() in <node> has an unusual period: <period_s> s',
        '  why:    create_timer() expects seconds: 0.5 means twice a second',
        '  do:     if you want another period, write the seconds between two calls, such as create_timer(0.1, ...) for ten calls a second',
    ]
    example = lines[lines.index('Example (lines with - are the mistake, lines with + are the fix):') :]
    assert any(line.startswith('  -') and 'create_timer' in line for line in example)
    assert any(line.startswith('  +') and 'create_timer' in line for line in example)


def test_the_nearest_rule_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['explain', 'tf.unknown-fram']) == 2
    assert capsys.readouterr().err.splitlines()[0].endswith("there is no rule 'tf.unknown-fram'")
    assert main(['explain', 'tf.unknown-fram']) == 2
    assert 'write tf.unknown-frame' in capsys.readouterr().err


def test_a_file_is_no_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    assert all(map(is_rule, all_rules()))
    assert not is_rule('my.launch.py') and not is_rule('turtlesim') and not is_rule('launch.py/x')

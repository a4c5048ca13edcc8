"""What the Tab key offers for the commands of edugrade that grade a class."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.cli.candidates import candidates
from edulaunch.runtime.plugins import grading_verbs


@pytest.mark.parametrize(
    ('line', 'offered'),
    [
        ('edugrade ver', ['verify']),
        ('edugrade export --l', ['--late-per-day', '--list']),
        ('edugrade export moo', ['moodle']),
        ('edugrade batch --sandbox r', ['require']),
        ('edugrade gradescope build --w', ['--wheel']),
    ],
)
def test_the_tab_key_offers(line: str, offered: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert candidates(line, break_words=False) == offered


def test_each_command_with_options_has_a_parser() -> None:
    verbs = grading_verbs()
    offered = {verb: candidates(f'edugrade {verb} --', break_words=False) for verb in verbs}
    assert {verb for verb, options in offered.items() if options == ['--help']} == {'doctor', 'schema', 'gradescope'}

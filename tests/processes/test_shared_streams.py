"""What shared modules write reaches the program that made them write."""

from __future__ import annotations

import io
import sys
from contextlib import redirect_stdout
from typing import Any

import pytest

from edulaunch.processes.shared_streams import streams_of_programs


def test_a_usage_error_is_told_on_the_programs_own_stderr(world: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert world.run(
        """
        import argparse
        parser = argparse.ArgumentParser()
        parser.add_argument('--speed', type=float)
        parser.parse_args()
        """,
        'drive',
        '--sped',
        '2',
    ) == ('usage: drive.py [-h] [--speed SPEED]\ndrive.py: error: unrecognized arguments: --sped 2\n')
    assert world.codes == {'drive': 2} and capsys.readouterr() == ('', '')


@pytest.mark.parametrize(
    ('text', 'wrote'),
    [
        (
            'import traceback\ntry:\n    1 / 0\nexcept ZeroDivisionError:\n    traceback.print_exc(limit=0)',
            'ZeroDivisionError: division by zero\n',
        ),
        (
            'import contextlib, io\nwith contextlib.redirect_stdout(io.StringIO()) as box:\n    print("in")\nprint(box.getvalue())',
            'in\n\n',
        ),
        ('import cmd\ncmd.Cmd.do_go = lambda self, words: print("goes", words)\ncmd.Cmd().cmdloop()', None),
    ],
)
def test_modules_that_write_use_the_programs_streams(world: Any, text: str, wrote: str | None) -> None:
    if wrote is None:
        world.host._stdin['program-1'] = 'go home\nEOF\n'
        assert world.run(text, seconds=1).startswith('(Cmd) goes home\n')
    else:
        assert world.run(text) == wrote


def test_shared_modules_write_to_the_program_that_runs(world: Any, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ('a-1', 'b-2'):
        world.start(world.write('w.py', 'import pprint, sys\npprint.pprint(sys.argv[1])'), name, name)
    with streams_of_programs():
        world.sim.run()
    assert [(who, text) for _, who, text in world.log if text != '\n'] == [('a-1', "'a-1'"), ('b-2', "'b-2'")]
    assert capsys.readouterr() == ('', '')


def test_what_hands_output_on_writes_to_the_real_streams(world: Any, capsys: pytest.CaptureFixture[str]) -> None:
    process = world.start(world.write('w.py', 'print("hello")'))
    process.on_output = lambda stream, text: print('console:', text, end='')
    with streams_of_programs():
        world.sim.run()
    assert capsys.readouterr().out == 'console: hello\n'


def test_the_real_streams_are_put_back_unless_somebody_else_took_them() -> None:
    before, other = sys.stdout, io.StringIO()
    with streams_of_programs():
        assert sys.stdout is not before
    assert sys.stdout is before
    with redirect_stdout(before):
        with streams_of_programs():
            sys.stdout = other
        assert sys.stdout is other

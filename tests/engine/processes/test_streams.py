"""What shared modules write reaches the program that made them write.

Addresses are numbered, so that recordings repeat.
"""

from __future__ import annotations

import io
import sys
from contextlib import redirect_stdout
from typing import Any

import pytest

from edulaunch.engine.processes.streams import Addresses, streams_of_programs


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


def test_addresses_are_numbered_in_the_order_of_their_appearance() -> None:
    steady = Addresses().steady
    assert steady('<A at 0x7f34123fd410>, <B object at 0x55d0a1b2>') == '<A at 0x7f0000000010>, <B object at 0x7f0000000020>'
    assert steady('again <A at 0x7f34123fd410>') == 'again <A at 0x7f0000000010>'


def test_what_is_numbered_stays_as_it_is() -> None:
    addresses = Addresses()
    once = addresses.steady('<A at 0x7f34123fd410> <B at 0x7f34123fd420>')
    assert addresses.steady(once) == once


def test_other_numbers_are_left_alone() -> None:
    text = 'port 0x7f34123fd410 at 0x10, mask at 0xZZ, at 0x'
    assert Addresses().steady(text) == text


def test_a_printed_object_looks_the_same_in_every_run(world: Any) -> None:
    program = 'class A: pass\nkept = [A() for _ in range(3)]\nprint(kept[2], kept[0].__init__)\nprint(kept[0])'
    assert world.run(program) == (
        '<__main__.A object at 0x7f0000000010> '
        "<method-wrapper '__init__' of A object at 0x7f0000000020>\n<__main__.A object at 0x7f0000000020>\n"
    )


def test_a_logged_object_too(world: Any) -> None:
    world.write('p.py', "import rclpy\nrclpy.init()\nnode = rclpy.create_node('n')\nnode.get_logger().info(str(object()))")
    assert '[n]: <object object at 0x7f0000000010>\n' in world.run((world.folder / 'p.py').read_text())


def test_the_streams_of_a_program_answer_as_those_of_a_pipe_do(world: Any) -> None:
    text = """
        import sys
        for each in (sys.stdout, sys.stderr):
            assert (each.name, each.isatty(), each.readable(), each.writable(), each.closed) == (each.name, False, False, True, False)
            print(each.name, each.fileno(), each.write('four'), each.buffer.write(b'five5'))
        try:
            sys.stdout.write(b'bytes')
        except TypeError as error:
            print(error)
        """
    told = world.run(text)
    assert '<stdout> 1 4 5' in told and '<stderr> 2 4 5' in told and 'must be str, not bytes' in told

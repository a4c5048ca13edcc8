"""What each filter after a `|` passes on, and when."""

from __future__ import annotations

import os

import pytest

from edulaunch.runtime.shell.filters import Filter, RealFilter, is_filter


class Out:
    def __init__(self) -> None:
        self.text = ''
        self.is_closed = False

    def write(self, text: str) -> None:
        self.text += text

    def close(self) -> None:
        self.is_closed = True


def through(command: str, text: str) -> tuple[str, int]:
    out = Out()
    one = Filter(command.split(), out, lambda: None)
    one.write(text)
    one.close()
    assert out.is_closed
    return out.text, one.returncode


TEXT = 'b 2\na 10\nb 2\nb 2\nA -1\n'


@pytest.mark.parametrize(
    ('command', 'lines'),
    [
        ('cat', ['b 2', 'a 10', 'b 2', 'b 2', 'A -1']),
        ('grep a', ['a 10']),
        ('grep -i a', ['a 10', 'A -1']),
        ('grep -v b', ['a 10', 'A -1']),
        ('grep -c b', ['3']),
        ('grep -vc b', ['2']),
        ('grep -n a', ['2:a 10']),
        ('grep -no 1', ['2:1', '5:1']),
        ('grep -w 1', ['A -1']),
        ('grep -F .', []),
        ('grep -e A', ['A -1']),
        ('grep a\\|A', ['a 10', 'A -1']),
        ('grep -E a|A', ['a 10', 'A -1']),
        ('head -n 2', ['b 2', 'a 10']),
        ('head -1', ['b 2']),
        ('head', ['b 2', 'a 10', 'b 2', 'b 2', 'A -1']),
        ('tail -n 2', ['b 2', 'A -1']),
        ('tail -1', ['A -1']),
        ('sort', ['A -1', 'a 10', 'b 2', 'b 2', 'b 2']),
        ('sort -r', ['b 2', 'b 2', 'b 2', 'a 10', 'A -1']),
        ('sort -u', ['A -1', 'a 10', 'b 2']),
        ('uniq', ['b 2', 'a 10', 'b 2', 'A -1']),
        ('uniq -c', ['      1 b 2', '      1 a 10', '      2 b 2', '      1 A -1']),
        ('wc', ['5 10 22']),
        ('wc -l', ['5']),
        ('wc -w', ['10']),
        ('wc -c', ['22']),
        ('wc -lc', ['5 22']),
    ],
)
def test_lines_that_come_through(command: str, lines: list[str]) -> None:
    assert through(command, TEXT)[0].splitlines() == lines


def test_ten_lines_are_enough_for_head_and_tail_and_numbers_are_sorted_as_numbers() -> None:
    text = ''.join(f'{number}\n' for number in range(12, 0, -1))
    assert through('head', text)[0].split() == [str(number) for number in range(12, 2, -1)]
    assert through('tail', text)[0].split() == [str(number) for number in range(10, 0, -1)]
    assert through('sort -n', text + 'x\n -0.5\n')[0].split() == ['-0.5', 'x', *map(str, range(1, 13))]


@pytest.mark.parametrize(('command', 'code'), [('grep b', 0), ('grep x', 1), ('grep -c x', 1), ('head -1', 0)])
def test_the_status_says_whether_grep_found_something(command: str, code: int) -> None:
    assert through(command, TEXT)[1] == code


def test_head_stops_what_writes_at_its_last_line_and_half_a_line_waits() -> None:
    out, stops = Out(), list[str]()
    one = Filter(['head', '-n', '2'], out, lambda: stops.append(out.text))
    one.write('a')
    assert out.text == ''
    one.write('\nb\nc\nd\n')
    one.write('e\n')
    assert (out.text, stops) == ('a\nb\n', ['a\nb\n'])
    one.close()
    assert out.text == 'a\nb\n'


def test_a_last_line_without_an_end_is_a_line() -> None:
    assert through('cat', 'a\nb')[0] == 'a\nb\n'


@pytest.mark.parametrize(
    ('command', 'is_one'),
    [
        ('grep x', True),
        ('grep x file', False),
        ('grep -P x', False),
        ('head -5', True),
        ('head file', False),
        ('cat', True),
        ('cat file', False),
        ('sort -k2', False),
        ('wc -l', True),
        ('sed s/a/b/', False),
        ('uniq -c', True),
        ('tail -f', False),
    ],
)
def test_what_reads_files_or_has_rare_options_is_left_to_the_real_program(command: str, is_one: bool) -> None:
    assert is_filter(command.split()) is is_one


def test_another_program_gets_the_whole_input_at_its_end() -> None:
    out = Out()
    one = RealFilter(['tr', 'ab', 'xy'], out, None, dict(os.environ))
    one.write('a1')
    one.write('b2')
    assert (out.text, out.is_closed) == ('', False)
    one.close()
    assert (out.text, one.returncode, out.is_closed) == ('x1y2', 0, True)


def test_a_program_that_does_not_exist_is_said_as_a_shell_says_it() -> None:
    out = Out()
    one = RealFilter(['no_such_program'], out, None, dict(os.environ))
    one.close()
    assert (out.text, one.returncode, out.is_closed) == ('sh: no_such_program: not found\n', 127, True)

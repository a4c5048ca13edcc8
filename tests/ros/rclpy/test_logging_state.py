"""How lines of the log look, and which are written where."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from rclpy.impl.logging_state import ConsoleFormat, LoggingState, Record

NOON_NS = 1_700_000_000_012_345_678
RECORD = Record(30, 'a.b', 'hello', NOON_NS, 'main', '/a.py', 7)


@pytest.mark.parametrize(
    ('text', 'line'),
    [
        ('', '[WARN] [1700000000.012345678] [a.b]: hello'),
        ('{severity} {name} {message}', 'WARN a.b hello'),
        ('{function_name}:{file_name}:{line_number}', 'main:/a.py:7'),
        ('{time} {time_as_nanoseconds}', f'1700000000.012345678 {NOON_NS}'),
        ('{date_time_with_ms}', '2023-11-14 22:13:20.012'),
        ('{unknown} {name', '{unknown} {name'),
        ('a} {{name}}', 'a} {a.b}'),
    ],
)
def test_a_format_says_what_a_line_shows(text: str, line: str) -> None:
    assert ConsoleFormat({'RCUTILS_CONSOLE_OUTPUT_FORMAT': text}).line(RECORD) == f'{line}\n'


def test_early_times_have_ten_digits() -> None:
    assert ConsoleFormat({}).line(RECORD._replace(stamp_ns=5_000_000_001)) == '[WARN] [0000000005.000000001] [a.b]: hello\n'
    assert ConsoleFormat({'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{date_time_with_ms}'}).line(RECORD._replace(stamp_ns=0)) == (
        '1970-01-01 00:00:00.000\n'
    )


@pytest.mark.parametrize(('severity', 'color'), [(10, '32'), (20, '0'), (30, '33'), (40, '31'), (50, '31')])
def test_colours_are_those_of_the_severity(severity: int, color: str) -> None:
    colored = ConsoleFormat({'RCUTILS_COLORIZED_OUTPUT': '1', 'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{message}'})
    assert colored.line(RECORD._replace(severity=severity)) == f'\033[{color}mhello\033[0m\n'
    plain = ConsoleFormat({'RCUTILS_COLORIZED_OUTPUT': '0', 'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{message}'})
    assert plain.line(RECORD) == 'hello\n'


@pytest.mark.parametrize(('value', 'stream'), [('1', 'stdout'), ('0', 'stderr'), (None, 'stderr')])
def test_a_variable_chooses_the_stream(value: str | None, stream: str) -> None:
    assert ConsoleFormat({} if value is None else {'RCUTILS_LOGGING_USE_STDOUT': value}).stream == stream


class FakeProcess:
    def __init__(self) -> None:
        self.env: dict[str, str] = {}
        self.streams = SimpleNamespace(steady=str.upper)
        self.sim = SimpleNamespace(now_ns=2_000_000_003)
        self.written: list[tuple[Any, ...]] = []

    def write(self, *row: Any) -> None:
        self.written.append(row)

    def log(self, *row: Any) -> None:
        self.written.append(row)


def test_a_message_goes_to_the_console_the_recording_and_rosout() -> None:
    process = FakeProcess()
    state, sent = LoggingState(process), list[Any]()
    state.rosout['a'] = SimpleNamespace(destroyed=False, publish=sent.append)
    state.rosout['gone'] = SimpleNamespace(destroyed=True, publish=sent.append)
    for name in ('a', 'b', 'gone'):
        state.output(20, name, 'x', 'f', 'file', 9)
    assert process.written[:2] == [('stderr', '[INFO] [0000000002.000000003] [a]: X\n'), (20, 'a', 'X')]
    assert len(process.written) == 6
    assert sent == [(2, 3, 20, 'a', 'X', 'file', 'f', 9)]


def test_arguments_switch_outputs_off_and_set_levels() -> None:
    process = FakeProcess()
    state, sent = LoggingState(process), list[Any]()
    state.rosout['a'] = SimpleNamespace(destroyed=False, publish=sent.append)
    arguments: Any = SimpleNamespace(log_levels={'': 30, 'a': 40}, outputs={})
    state.configure(arguments)
    assert (state.console, state.rosout_enabled, state.effective_level('b'), state.effective_level('a.c')) == (True, True, 30, 40)
    arguments = SimpleNamespace(log_levels={}, outputs={'stdout': False, 'rosout': False})
    state.configure(arguments)
    state.output(40, 'a', 'x')
    assert (process.written, sent) == ([(40, 'a', 'X')], [])


def test_a_level_is_that_of_the_nearest_name_that_has_one() -> None:
    state = LoggingState(FakeProcess())
    assert [state.effective_level(name) for name in ('', 'a', 'a.b')] == [20, 20, 20]
    state.set_level('a', 10)
    state.set_level('a.b.c', 50)
    assert [state.effective_level(name) for name in ('', 'a', 'a.b', 'a.b.c', 'a.b.c.d', 'ab')] == [20, 10, 10, 50, 50, 20]
    state.set_level('', 40)
    assert [state.effective_level(name) for name in ('x', 'a.b')] == [40, 10]
    state.set_level('a', 0)
    state.set_level('', 0)
    state.set_level('nix', 0)
    assert [state.effective_level(name) for name in ('x', 'a.b', 'a.b.c')] == [20, 20, 50]

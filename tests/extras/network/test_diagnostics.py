from __future__ import annotations

import pytest

from edulaunch.extras.network.diagnostics import MOST, LinkDiagnostics
from edulaunch.extras.network.network_link import LinkDiagnostic


def test_troubles_that_differ_in_a_name_alone_are_one_line() -> None:
    said: list[str] = []
    diagnostics = LinkDiagnostics(said.append)
    for name in ('/a', '/b', '/c', '/d', '/e', '/a'):
        diagnostics.add(LinkDiagnostic(f'client {name}', f'a real node has the service {name}: no\n  help: rclpy', name))
    diagnostics.add(LinkDiagnostic('full', 'too slow'))
    assert diagnostics.lines() == ['a real node has the service /a, /b, /c and 2 more: no\n  help: rclpy (6 times)', 'too slow']
    assert len(said) == 6


def test_a_problem_is_reported_and_noted_once() -> None:
    said: list[str] = []
    noted: list[str] = []
    diagnostics = LinkDiagnostics(said.append, noted.append)
    for _ in range(2):
        diagnostics.add(LinkDiagnostic('full', 'too slow'))
    assert (said, noted, diagnostics.lines()) == (['too slow'], ['full'], ['too slow (2 times)'])


@pytest.mark.parametrize(('names', 'line'), [('abc', 'no a, b, c'), ('abcd', 'no a, b, c and 1 more')])
def test_a_line_lists_three_names(names: str, line: str) -> None:
    diagnostics = LinkDiagnostics(lambda text: None)
    for name in names:
        diagnostics.add(LinkDiagnostic(name, f'no {name}', name))
    assert diagnostics.lines() == [line]


def test_after_99_problems_the_others_are_neither_reported_nor_counted() -> None:
    said: list[str] = []
    diagnostics = LinkDiagnostics(said.append)
    for number in range(MOST + 5):
        diagnostics.add(LinkDiagnostic(str(number), f'problem {number}'))
    diagnostics.add(LinkDiagnostic('0', 'problem 0'))
    assert len(said) == 99 and len(diagnostics.lines()) == 100
    assert diagnostics.lines()[0] == 'problem 0 (2 times)'

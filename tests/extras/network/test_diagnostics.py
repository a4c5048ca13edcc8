from __future__ import annotations

from edulaunch.extras.network.diagnostics import LinkDiagnostics
from edulaunch.extras.network.network_link import LinkDiagnostic


def test_troubles_that_differ_in_a_name_alone_are_one_line() -> None:
    said: list[str] = []
    diagnostics = LinkDiagnostics(said.append)
    for name in ('/a', '/b', '/c', '/d', '/e', '/a'):
        diagnostics.add(LinkDiagnostic(f'client {name}', f'a real node has the service {name}: no\n  help: rclpy', name))
    diagnostics.add(LinkDiagnostic('full', 'too slow'))
    assert diagnostics.lines() == ['a real node has the service /a, /b, /c and 2 more: no\n  help: rclpy (6 times)', 'too slow']
    assert len(said) == 6

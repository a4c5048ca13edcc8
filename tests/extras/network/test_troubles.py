from __future__ import annotations

from edulaunch.extras.network.link import Trouble
from edulaunch.extras.network.troubles import Troubles


def test_troubles_that_differ_in_a_name_alone_are_one_line() -> None:
    said: list[str] = []
    troubles = Troubles(said.append)
    for name in ('/a', '/b', '/c', '/d', '/e', '/a'):
        troubles.add(Trouble(f'client {name}', f'a real node has the service {name}: no\n  help: rclpy', name))
    troubles.add(Trouble('full', 'too slow'))
    assert troubles.lines() == ['a real node has the service /a, /b, /c and 2 more: no\n  help: rclpy (6 times)', 'too slow']
    assert len(said) == 6

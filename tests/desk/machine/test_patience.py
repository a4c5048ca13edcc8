"""How long a terminal waits for the first answer of a machine."""

from __future__ import annotations

import socket
from collections.abc import Sequence

import pytest

from edulaunch.desk.machine import client
from edulaunch.desk.machine.following import GIVE_UP_S
from edulaunch.desk.machine.place import Address


@pytest.mark.parametrize(
    ('words', 'start', 'patience_s'),
    [
        (['machine', 'network', 'on'], True, GIVE_UP_S),  # a machine that starts on a busy computer takes longer than 3 s
        (['machine', 'network', 'status'], False, client.ANSWER_S),
        (['topic', 'list'], True, GIVE_UP_S),
    ],
)
def test_a_machine_that_may_be_starting_gets_more_time(
    monkeypatch: pytest.MonkeyPatch, words: Sequence[str], start: bool, patience_s: float
) -> None:
    ours, theirs = socket.socketpair()
    waits: list[float] = []

    class Follower(client.Follower):
        def run(self, first: bytes) -> int:
            waits.append(self._give_up_s)
            return 0

    monkeypatch.setattr(client, 'Follower', Follower)
    monkeypatch.setattr(client, 'connect', lambda number, *, start: (ours, Address('unix', '', '', 0, 'terminals')))
    with theirs:
        assert client.run(words, start=start) == 0
    assert waits == [patience_s]

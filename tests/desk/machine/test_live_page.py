"""What a page in a browser may send: JSON in lines, and nothing that ends the machine."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.desk.machine import live_page, wire
from edulaunch.desk.machine.live_page import LONGEST_LINE, LivePage


class Heard:
    """A viewer that logs what it takes."""

    def __init__(self, *_: Any) -> None:
        self.log: list[Any] = []

    def show(self) -> None:
        self.log.append('next')

    def take(self, request: Any) -> None:
        self.log.append(request)

    def close(self) -> None:
        self.log.append('closed')


@pytest.fixture
def page(monkeypatch: pytest.MonkeyPatch) -> tuple[LivePage, Heard]:
    heard = Heard()
    monkeypatch.setattr(live_page, 'Viewer', lambda *_: heard)
    machine: Any = None
    return LivePage(machine, lambda *_: None, lambda _: None), heard


def test_lines_come_in_pieces(page: tuple[LivePage, Heard]) -> None:
    one, heard = page
    one.take(wire.INPUT, b'{"op": "ne')
    one.take(wire.INPUT, b'xt"}\n{"op": "pause"}\n[1]\n{')
    assert heard.log == ['next', {'op': 'pause'}, [1]]


@pytest.mark.parametrize(
    'data', [b'{\n', b'\xff\n', b'[' * 100_000 + b'\n', b'x' * (LONGEST_LINE + 1)], ids=['half', 'bytes', 'nested', 'endless']
)
def test_what_is_not_json_is_a_value_error(page: tuple[LivePage, Heard], data: bytes) -> None:
    one, heard = page
    with pytest.raises(ValueError):
        one.take(wire.INPUT, data)
    assert heard.log == []


def test_what_the_viewer_says_is_a_line_of_json_and_the_end_closes_it(monkeypatch: pytest.MonkeyPatch) -> None:
    heard, log = Heard(), list[Any]()
    says: list[Any] = []

    def viewer(machine: Any, say: Any, typed_in: Any) -> Heard:
        says.append(say)
        return heard

    monkeypatch.setattr(live_page, 'Viewer', viewer)
    machine: Any = None
    one = LivePage(machine, lambda *frame: log.append(frame), log.append)
    says[0]({'a': [1, 2]})
    one.take(wire.SIZE, b'not read\n')
    one.take(wire.INPUT, b' ' * LONGEST_LINE)
    one.hang_up()
    assert (log, heard.log) == ([(wire.OUTPUT, b'{"a":[1,2]}\n'), one], ['closed'])

"""Ctrl-C while a program keeps its turn: the first press says where, the second one stops it there."""

from __future__ import annotations

import signal
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import edulaunch

pytestmark = pytest.mark.skipif(not hasattr(signal, 'setitimer'), reason='no such signal on this system')

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {script!r}], output='screen')])
"""
LOOP = """import button
button.press()
while not button.is_told():
    for _ in range(10**6):
        pass
button.press()
"""
PATTERN = """import re
import button
button.press()
re.match('(a+)+b', 'a' * 40)
"""


class Heard:
    """What came on the error stream until now."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self._capsys = capsys
        self._text = ''

    def text(self) -> str:
        self._text += self._capsys.readouterr().err
        return self._text


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Heard:
    """The error stream; the person at the keyboard is a module that programs import."""
    heard, button = Heard(capsys), ModuleType('button')
    module: Any = button
    module.press = lambda: signal.raise_signal(signal.SIGINT)
    module.is_told = heard.text
    monkeypatch.setitem(sys.modules, 'button', button)
    return heard


def launch_file(folder: Path, text: str) -> Path:
    script, file = folder / 'turtle.py', folder / 'one.launch.py'
    script.write_text(text)
    file.write_text(LAUNCH.format(script=str(script)))
    return file


def test_a_loop(tmp_path: Path, said: Heard) -> None:
    edulaunch.run(launch_file(tmp_path, LOOP), duration_s=1.0)
    line = said.text().strip().split('\n')[0]
    assert line in [f'note: still in turtle.py:{n}; press Ctrl-C or the interrupt button again to stop' for n in (4, 5)]
    assert signal.getsignal(signal.SIGALRM) is signal.SIG_DFL


def test_a_call_of_c_code_that_looks_for_signals(tmp_path: Path, said: Heard) -> None:
    presses = signal.signal(signal.SIGVTALRM, lambda signum, frame: signal.raise_signal(signal.SIGINT))
    signal.setitimer(signal.ITIMER_VIRTUAL, 1.5)  # the second press comes from outside
    try:
        edulaunch.run(launch_file(tmp_path, PATTERN), duration_s=1.0)
    finally:
        signal.signal(signal.SIGVTALRM, presses)
    assert 'note: still in turtle.py:4; press' in said.text()


def test_a_run_that_stops_at_once_says_nothing(tmp_path: Path, said: Heard) -> None:
    edulaunch.run(launch_file(tmp_path, 'import button, time\nbutton.press()\ntime.sleep(1)\n'), duration_s=3.0)
    text = said.text()
    assert 'still' not in text and 'interrupted' in text

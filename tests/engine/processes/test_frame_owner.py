"""Whose code a file is, and where a program of a student is now."""

from __future__ import annotations

import asyncio
import json
import os
import sys
import threading
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.processes.frame_owner import coroutine_line, is_engine, is_library, is_own, student_line


@pytest.mark.parametrize(
    ('file', 'owner'),
    [
        (edulaunch.__file__, 'engine'),
        ('<frozen importlib._bootstrap>', 'engine'),
        ('<interface std_msgs>', 'engine'),
        (json.__file__, 'library'),
        (pytest.__file__, 'library'),
        ('/home/student/ws/src/robot/robot/drive.py', 'own'),
        ('/home/student/ws/install/robot/lib/python3.12/site-packages/robot/drive.py', 'own'),
        ('<string>', 'own'),
        (os.path.dirname(os.path.abspath(edulaunch.__file__)) + '_of_mine/drive.py', 'own'),
    ],
)
def test_each_file_has_one_owner(file: str, owner: str) -> None:
    file = os.path.abspath(file) if not file.startswith('<') else file
    assert {'engine': is_engine(file), 'library': is_library(file), 'own': is_own(file)} == {
        each: each == owner for each in ('engine', 'library', 'own')
    }


def written(text: str, file: str) -> Any:
    """Run a text as a file; returns its names."""
    names: dict[str, Any] = {'sys': sys, 'json': json, 'asyncio': asyncio}
    exec(compile(text, file, 'exec'), names)
    return names


def test_the_line_of_the_student_names_what_it_calls(tmp_path: Path) -> None:
    file = str(tmp_path / 'drive.py')
    seen: list[dict[str, Any]] = []

    def hook(frame: FrameType, event: str, argument: Any) -> None:
        if event == 'call' and frame.f_code.co_name == 'loads' and not seen:
            seen.append(student_line(frame))

    names = written('def go(path):\n    x = 1\n    return json.loads("1")\n', file)
    before = sys.getprofile()
    sys.setprofile(hook)
    try:
        names['go'](file)
    finally:
        sys.setprofile(before)
    assert seen == [{'file': file, 'line': 3, 'function': 'go', 'calls': '__init__.loads'}]


def test_the_student_itself_calls_nothing(tmp_path: Path) -> None:
    file = str(tmp_path / 'drive.py')
    frame = written('def here():\n    return sys._getframe()\n', file)['here']()
    assert student_line(frame) == {'file': file, 'line': 2, 'function': 'here'}


def test_a_coroutine_waits_in_the_innermost_line_of_the_student(tmp_path: Path) -> None:
    outer, inner = str(tmp_path / 'outer.py'), str(tmp_path / 'inner.py')
    waits = written('async def wait(future):\n    await future\n', inner)['wait']
    coroutine = written('async def call(wait, future):\n    x = 1\n    await wait(future)\n', outer)['call']
    loop = asyncio.new_event_loop()
    made = coroutine(waits, loop.create_future())
    made.send(None)
    assert coroutine_line(made) == {'file': inner, 'line': 2, 'function': 'wait'}
    made.close()
    loop.close()
    assert coroutine_line(made) == {}


def test_no_line_of_a_student_is_an_empty_answer() -> None:
    seen: list[dict[str, Any]] = []

    def ask() -> None:
        frame = sys._getframe()
        while frame.f_back is not None:
            frame = frame.f_back
        seen.append(student_line(frame))  # that of the module threading, in which the thread begins

    thread = threading.Thread(target=ask)
    thread.start()
    thread.join()
    assert seen == [{}]

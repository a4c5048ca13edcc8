"""Where actions come from, whatever made them and however long the file is."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest
from launch import Action, LaunchContext, LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.utilities.entities import visit_all_entities_and_collect_futures


def seconds_per_action(constants: int) -> float:
    """To make actions, and to ask for their lines, in a function of a text with so many constants."""
    names: dict[str, Any] = {'LogInfo': LogInfo}
    numbers = ', '.join(str(float(number)) for number in range(constants))
    exec(
        f'def make(n):\n    x = [{numbers}, n] if n < 0 else 0\n    while n:\n        LogInfo(msg="").origin\n        n -= 1\n',
        names,
    )
    names['make'](1)
    times = []
    for _ in range(5):
        began = time.process_time()
        names['make'](50)
        times.append(time.process_time() - began)
    return min(times)


def test_the_line_costs_the_same_in_a_long_file_as_in_a_short_one() -> None:
    assert seconds_per_action(50_000) < 8 * seconds_per_action(1)


class Pair(Action):
    """An action of somebody's own that leads to one of launch's."""

    def execute(self, context: LaunchContext) -> list[Any]:
        return [LogInfo(msg='made by hand')]


def test_what_a_students_action_makes_comes_from_its_own_line() -> None:
    (made,) = Pair().execute(LaunchContext())
    (again,) = Pair().visit(LaunchContext()) or ()
    assert made.origin == again.origin
    assert made.origin.file == __file__


def create(text: str) -> LogInfo:
    return LogInfo(msg=text)


def create_several(*texts: str) -> list[LogInfo]:
    return [create(text) for text in texts]


def test_an_action_knows_which_functions_of_its_file_were_called_to_create_it() -> None:
    """A comprehension is part of the function around it, in Python 3.10 and in Python 3.12."""
    mine = [LogInfo(msg=text) for text in 'a'][0]
    made = create_several('a')[0]
    first = create.__code__.co_firstlineno
    assert made.origin is not None and made.origin.line == first + 1
    names = [name for name, _ in made.calls]
    assert names[:2] == ['create', 'create_several']
    assert [place.line for _, place in made.calls][0] == first + 5
    assert mine.calls == []


def test_a_wrong_argument_of_an_include_is_shown_at_the_include(tmp_path: Path) -> None:
    (tmp_path / 'b.launch.py').write_text(
        'from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription()\n'
    )
    (tmp_path / 'a.launch.xml').write_text(
        '<launch>\n\n<include file="$(dirname)/b.launch.py"><arg name="x" value="$(eval 1/0)"/></include>\n</launch>\n'
    )
    include = IncludeLaunchDescription(str(tmp_path / 'a.launch.xml'))
    with pytest.raises(ZeroDivisionError) as error:
        visit_all_entities_and_collect_futures(LaunchDescription([include]), LaunchContext())
    assert error.value.edulaunch_origin == (str(tmp_path / 'a.launch.xml'), 3)  # type: ignore[attr-defined]

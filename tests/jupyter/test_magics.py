"""The magics in a real IPython shell."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.recording import Recording


@pytest.fixture
def shell(desk: Any) -> Iterator[Any]:
    """An IPython shell that has loaded the extension."""
    from IPython.core.interactiveshell import InteractiveShell

    InteractiveShell.clear_instance()
    shell: Any = InteractiveShell.instance(colors='nocolor')
    shell.history_manager.enabled = False
    shell.run_line_magic('load_ext', 'edulaunch.jupyter')
    yield shell
    shell.history_manager.end_session()
    InteractiveShell.clear_instance()


def test_a_launch_is_assigned_like_any_value(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell('recording = %ros2 launch sim.launch.py --for 1\nnow = %recording')
    assert isinstance(shell.user_ns['recording'], Recording) and shell.user_ns['now'].duration_s == 1.0
    assert 'process started with pid [1002]' in capsys.readouterr().out


def test_braces_reach_the_command_as_they_are(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell('x = 5\n%ros2 launch sim.launch.py --for 1')
    shell.run_cell('%ros2 topic pub --once -w 0 /chatter std_msgs/msg/String "{data: hello $x}"')
    assert "std_msgs.msg.String(data='hello $x')" in capsys.readouterr().out


def test_an_error_is_shown_without_a_traceback_of_ours(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    result = shell.run_cell('%ros2 launch simm.launch.py')
    said = capsys.readouterr().out
    assert type(result.error_in_exec).__name__ == 'UnusableInput'
    assert said.strip().splitlines() == [
        "UnusableInput: launch file 'simm.launch.py' does not exist.",
        "  help: did you mean 'sim.launch.py'?",
    ]


def test_sourcing_and_its_error(shell: Any, desk: Any, capsys: pytest.CaptureFixture[str]) -> None:
    desk.write('ws/src/mine/package.xml', '<package format="3"><name>mine</name></package>')
    assert shell.run_cell('%source ws/install/setup.bash').success
    assert not shell.run_cell('%source wss').success
    assert 'there is no such workspace' in capsys.readouterr().out

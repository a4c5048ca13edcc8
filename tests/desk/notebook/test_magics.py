"""The magics in a real IPython shell."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.advice.workspace.not_needed import answer
from edulaunch.engine.recording import Recording


@pytest.fixture(params=['edulaunch'])
def shell(desk: Any, request: pytest.FixtureRequest) -> Iterator[Any]:
    """An IPython shell that has loaded the extension."""
    from IPython.core.interactiveshell import InteractiveShell

    InteractiveShell.clear_instance()
    shell: Any = InteractiveShell.instance(colors='nocolor')
    shell.history_manager.enabled = False
    shell.run_line_magic('load_ext', request.param)
    yield shell
    shell.history_manager.end_session()
    InteractiveShell.clear_instance()


@pytest.mark.parametrize('shell', ['edulaunch', 'edulaunch.jupyter'], indirect=True)
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


def test_several_lines_of_a_cell_run_one_after_the_other(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    result = shell.run_cell('%%ros2\nlaunch sim.launch.py --for 1\n\n# who is there?\nnode list\ntopic list --for 1')
    assert isinstance(result.result, Recording)
    said = capsys.readouterr().out
    assert said.index('process started') < said.index('/sim\n') < said.index('/turtle1/pose\n')


def test_a_mistake_ends_the_lines(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert not shell.run_cell('%%ros2\nlaunch nothing.launch.py\nnode list').success
    assert '/sim' not in capsys.readouterr().out


@pytest.mark.parametrize(
    'cell', ['recording = %ros2 launch sim.launch.py --for 1 --quiet', '%%ros2 --quiet\nlaunch sim.launch.py --for 1']
)
def test_quiet_shows_nothing_but_what_is_wrong(shell: Any, capsys: pytest.CaptureFixture[str], cell: str) -> None:
    assert shell.run_cell(cell).success
    assert 'process started' not in capsys.readouterr().out
    shell.run_cell('%ros2 node list')
    assert capsys.readouterr().out == '/sim\n'
    assert not shell.run_cell('x = %ros2 launch sin.launch.py --for 1 --quiet').success
    assert "did you mean 'sim.launch.py'?" in capsys.readouterr().out


@pytest.mark.parametrize(
    ('cell', 'found'),
    [
        ('%ros2 topic ec', ['echo']),
        ('%ros2 launch sim', ['sim.launch.py']),
        ('%ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py targ', ['target_frame:=']),
        ('%ros2 run turtlesim turtle_tele', ['turtle_teleop_key']),
        ('r = %ros2 launch turtle_tf2_p', ['turtle_tf2_py']),
        ('%ros2 view fr', ['frames']),
        ('%ros2 launch sim.launch.py --qu', ['--quiet']),
        ('%%ros2\nnode list\ntopic hz /turtle1/po', ['/turtle1/pose']),
        ('%ros2 param get /s', ['/sim']),
        ('%ros2 param get /sim background_', ['background_b', 'background_g', 'background_r']),
    ],
)
def test_the_tab_key_completes_what_ros2_knows(shell: Any, cell: str, found: list[str]) -> None:
    from IPython.core.completer import provisionalcompleter

    shell.run_cell('r = %ros2 launch sim.launch.py --for 1 --quiet')
    with provisionalcompleter():
        completions = list(shell.Completer.completions(cell, len(cell)))
    assert [each.text for each in completions] == found
    assert all(cell[each.start :] and each.text.startswith(cell[each.start :]) for each in completions)


def test_the_tab_key_works_before_anything_runs_and_leaves_python_alone(shell: Any) -> None:
    from IPython.core.completer import provisionalcompleter

    with provisionalcompleter():
        assert [each.text for each in shell.Completer.completions('%ros2 run turtle_tf2_', 21)] == ['turtle_tf2_py']
        shell.user_ns['topic_of_mine'] = 1
        assert 'topic_of_mine' in [each.text for each in shell.Completer.completions('x = topic_of', 12)]


@pytest.mark.parametrize(
    ('line', 'part'),
    [
        ('plan sim.launch.py', 'turtlesim_node'),
        ('recording info nothing.rec', 'error: '),
        ('oops', "invalid choice: 'oops'"),
        ('launch "sim', 'add the missing quotation mark'),
    ],
)
def test_the_other_command_works_in_a_cell_too(shell: Any, capsys: pytest.CaptureFixture[str], line: str, part: str) -> None:
    result = shell.run_cell(f'%edulaunch {line}')
    told = capsys.readouterr()
    assert result.success and part in told.out and told.err == ''


@pytest.mark.parametrize('line', ['colcon build', 'rosdep install --from-paths src', 'apt install ros-jazzy-turtlesim'])
def test_a_step_that_is_not_needed_is_explained(shell: Any, line: str, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert shell.run_cell(f'%{line}').success
    assert answer(line.split()) in capsys.readouterr().out


@pytest.mark.parametrize(
    ('line', 'shown'), [('edulaunch rosdep', 'usage:'), ('edulaunch "doctor', 'error: No closing quotation: add')]
)
def test_a_command_line_that_is_wrong_has_no_traceback(
    shell: Any, line: str, shown: str, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert shell.run_cell(f'%{line}').success
    assert shown in capsys.readouterr().out

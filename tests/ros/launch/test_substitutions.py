"""Substitutions beyond the probes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnonName,
    AnySubstitution,
    Command,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    IfElseSubstitution,
    LaunchConfiguration,
    LaunchLogDir,
    LocalSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PathJoinSubstitution,
    PathSubstitution,
    PythonExpression,
    StringJoinSubstitution,
    SubstitutionFailure,
    ThisLaunchFile,
    ThisLaunchFileDir,
)

from edulaunch.engine.processes.commands import CommandSet


def test_a_local_may_be_indexed_and_need_not_be_a_text() -> None:
    context = LaunchContext()
    context.extend_locals({'table': {'name': 'n'}, 'event': Path('/a/b')})
    assert LocalSubstitution("table['name']").perform(context) == 'n'
    assert LocalSubstitution('event.parent').perform(context) == Path('/a')


def test_this_launch_file() -> None:
    context = LaunchContext()
    context.extend_locals({'current_launch_file_path': '/a/b.py', 'current_launch_file_directory': '/a'})
    assert (ThisLaunchFile().perform(context), ThisLaunchFileDir().perform(context)) == ('/a/b.py', '/a')


def test_an_anonymous_name_is_the_same_each_time_and_in_each_run() -> None:
    context, other = LaunchContext(), LaunchContext()
    name = AnonName('a-b.c')
    assert name.perform(context) == name.perform(context) == name.perform(other)
    assert name.perform(context).startswith('a_b_c_edulaunch_')


def test_one_value_of_two_is_needed() -> None:
    with pytest.raises(RuntimeError, match='One of if_value and else_value must be specified'):
        IfElseSubstitution('true')
    assert [IfElseSubstitution(c, 'a').perform(LaunchContext()) for c in ('yes', 'off')] == ['a', '']


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(SubstitutionFailure, match=f'File not found: {tmp_path}/x'):
        FileContent(str(tmp_path / 'x')).perform(LaunchContext())
    (tmp_path / 'x').write_text('ü\n')
    assert FileContent(str(tmp_path / 'x')).perform(LaunchContext()) == 'ü\n'


def test_the_log_folder_is_made_when_asked_for(tmp_path: Path, fresh_simulation: Any) -> None:
    fresh_simulation.env['ROS_HOME'] = str(tmp_path)
    assert Path(LaunchLogDir().perform(LaunchContext())).parent == tmp_path / 'log'


def test_commands_see_the_environment_of_the_launch(fresh_simulation: Any) -> None:
    fresh_simulation.env['SEEN'] = 'yes'
    assert Command("sh -c 'echo $SEEN'").perform(LaunchContext()) == 'yes\n'


def test_a_command_with_warnings_logs_them(capsys: Any) -> None:
    assert Command("sh -c 'echo oh >&2; echo out'", on_stderr='warn').perform(LaunchContext()) == 'out\n'
    assert '[WARNING] [root]: executed command showed stderr output.' in capsys.readouterr().out


def test_a_command_that_the_simulation_knows_runs_in_it(fresh_simulation: Any) -> None:
    def run(process: Any) -> int:
        from edulaunch.engine.sim.task import current_task

        current_task().sleep_until(process.sim.now_ns + 10**9)
        process.streams.stdout.write(' '.join(process.argv))
        return 0

    fresh_simulation.host.command_set = CommandSet({'ros2': run})
    assert Command('ros2 pkg list').perform(LaunchContext()) == 'ros2 pkg list'
    assert fresh_simulation.sim.elapsed_s == 1.0


def test_executables_are_looked_for_on_the_path_of_the_launch(tmp_path: Path, fresh_simulation: Any) -> None:
    program = tmp_path / 'my_tool'
    program.touch(mode=0o755)
    fresh_simulation.env['PATH'] = str(tmp_path)
    assert FindExecutable(name='my_tool').perform(LaunchContext()) == str(program)


def test_expressions_may_use_other_modules() -> None:
    assert PythonExpression("os.path.join('a', str(sin(0)))", ['os', 'math']).perform(LaunchContext()) == 'a/0.0'


def test_chance_in_an_expression_comes_from_the_simulation() -> None:
    def draw() -> str:
        return PythonExpression('random.random()', ['random']).perform(LaunchContext())

    first = draw()
    assert first != draw()


@given(st.floats(allow_nan=False))
def test_numbers_equal_themselves_however_written(number: float) -> None:
    assert EqualsSubstitution(number, f'{number!r}').perform(LaunchContext()) == 'true'


@pytest.mark.parametrize(
    ('left', 'right', 'equal'),
    [
        ('true', '1', True),
        ('True', True, True),
        ('FALSE', 0, True),
        (False, '0', True),
        ('1', '0', False),
        (True, 'false', False),
        ('1', '1.0', True),
        ('1e3', 1000, True),
        (0.3, 0.1 + 0.2, True),
        (0.3, 0.3000001, False),
        ('nan', 'nan', False),
        ('a', 'a', True),
        ('a', 'A', False),
        ('true', 'yes', False),
        (None, '', True),
        ([LaunchConfiguration('who'), '1'], 'turtle1', True),
    ],
)
def test_booleans_numbers_and_texts_are_compared_as_what_they_are(left: Any, right: Any, equal: bool) -> None:
    context = LaunchContext()
    context.launch_configurations['who'] = 'turtle'
    assert EqualsSubstitution(left, right).perform(context) == str(equal).lower()
    assert NotEqualsSubstitution(right, left).perform(context) == str(not equal).lower()


@pytest.mark.parametrize(
    ('values', 'both', 'either'),
    [([], 'true', 'false'), (['yes'], 'true', 'true'), (['1', 'off'], 'false', 'true'), (['no', 'False', '0'], 'false', 'false')],
)
def test_booleans_are_combined(values: list[str], both: str, either: str) -> None:
    context = LaunchContext()
    assert AllSubstitution(*values).perform(context) == both and AnySubstitution(*values).perform(context) == either
    if len(values) == 2:
        assert AndSubstitution(*values).perform(context) == both and OrSubstitution(*values).perform(context) == either


@pytest.mark.parametrize('combine', [AndSubstitution, OrSubstitution, AnySubstitution, AllSubstitution])
def test_every_operand_must_be_a_boolean_even_where_it_decides_nothing(combine: Any) -> None:
    for values in (('true', 'maybe'), ('false', 'maybe')):
        with pytest.raises(SubstitutionFailure, match='maybe'):
            combine(*values).perform(LaunchContext())


def test_a_combination_keeps_and_describes_its_operands() -> None:
    pair = AndSubstitution('a', LaunchConfiguration('b'))
    assert (pair.left[0].describe(), pair.right[0].describe()) == ("'a'", "LaunchConfig('b')")
    assert pair.describe() == "AndSubstitution('a' LaunchConfig('b'))"
    assert [operand[0].describe() for operand in AnySubstitution('a', 'b').args] == ["'a'", "'b'"]
    assert NotSubstitution('a').describe() == "NotSubstitution('a')" and NotSubstitution('no').perform(LaunchContext()) == 'true'
    assert EqualsSubstitution('a', 1).describe() == "EqualsSubstitution('a' '1')"


def test_paths_and_texts_are_joined() -> None:
    context = LaunchContext()
    context.launch_configurations['x'] = 'X'
    path = PathSubstitution('/a') / 'b' / ['c_', LaunchConfiguration('x'), '.py']
    assert path.perform(context) == '/a/b/c_X.py'
    assert StringJoinSubstitution(['a', ['b', LaunchConfiguration('x')]], delimiter=',').perform(context) == 'a,bX'
    assert PathJoinSubstitution(['a', '/b', 'c']).perform(context) == '/b/c'


def test_a_path_of_plain_texts_needs_no_context() -> None:
    nothing: Any = None
    assert PathJoinSubstitution(['a', 'b']).perform(nothing) == 'a/b'


def test_a_command_that_fails_is_an_error_with_what_it_wrote(fresh_simulation: Any) -> None:
    with pytest.raises(
        SubstitutionFailure, match=r"executed command failed. Command: sh -c 'echo oh >&2; exit 3'\nCaptured .* oh"
    ):
        Command("sh -c 'echo oh >&2; exit 3'", on_stderr='ignore').perform(LaunchContext())


def test_a_command_that_fails_in_the_simulation_is_an_error_too(fresh_simulation: Any) -> None:
    fresh_simulation.host.command_set = CommandSet({'ros2': lambda process: 3})
    with pytest.raises(SubstitutionFailure, match='executed command failed. Command: ros2 pkg list'):
        Command('ros2 pkg list').perform(LaunchContext())

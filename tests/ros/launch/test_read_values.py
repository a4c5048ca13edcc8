"""What arguments, groups, timers and texts of a launch file are read as."""

from __future__ import annotations

from typing import Any

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo, TimerAction
from launch.substitutions import LaunchConfiguration
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities._yaml_values import load_yaml_value
from launch.utilities.entities import normalize_to_list_of_entities
from launch.utilities.texts import plain_text


@pytest.mark.parametrize(
    ('description', 'choices', 'text'),
    [
        (None, None, 'no description given'),
        (None, ['a', 'b'], "One of: ['a', 'b']"),
        ('Which.', ['a'], "Which. Valid choices are: ['a']"),
        ('Which', ['a'], "Which. Valid choices are: ['a']"),
        ('Which', None, 'Which'),
    ],
)
def test_an_argument_is_described_with_its_choices(description: str | None, choices: list[str] | None, text: str) -> None:
    argument = DeclareLaunchArgument('x', description=description, choices=choices)
    assert (argument.description, argument.choices, argument.name, argument.default_value) == (text, choices, 'x', None)


@pytest.mark.parametrize(('choices', 'default'), [([], None), (['a'], 'b')])
def test_choices_must_have_the_default(choices: list[str], default: str | None) -> None:
    with pytest.raises(RuntimeError, match='choice'):
        DeclareLaunchArgument('x', choices=choices, default_value=default)
    assert DeclareLaunchArgument('x', choices=['a'], default_value='a').choices == ['a']


def test_a_group_is_a_scope_unless_told_otherwise() -> None:
    info = LogInfo(msg='a')

    def kinds(**given: Any) -> list[str]:
        group = GroupAction([info], launch_configurations={'x': '1'}, **given)
        assert group.execute(LaunchContext()) is group.get_sub_entities()
        return [type(one).__name__ for one in group.get_sub_entities()]

    begin, end = ['PushLaunchConfigurations', 'PushEnvironment'], ['LogInfo', 'PopEnvironment', 'PopLaunchConfigurations']
    assert kinds() == [*begin, 'SetLaunchConfiguration', *end]
    assert kinds(scoped=False) == ['SetLaunchConfiguration', 'LogInfo']
    assert kinds(forwarding=False) == [*begin, 'ResetEnvironment', 'ResetLaunchConfigurations', *end]


def test_a_timer_describes_itself() -> None:
    timer = TimerAction(period=2.0, actions=[LogInfo(msg='a')])
    assert timer.describe() == 'TimerAction(period=2.0, actions=<actions>)'
    assert timer.describe_conditional_sub_entities() == [('2.0 seconds pass without being canceled', timer.actions)]
    assert (timer.period, timer.get_asyncio_future()) == (2.0, None)
    with pytest.warns(UserWarning, match='passing a string literal is deprecated') as warned:
        assert TimerAction(period='3', actions=[]).period == 3.0
    assert warned[0].filename == __file__


@pytest.mark.parametrize(
    ('text', 'value'),
    [
        ('true', True),
        ('On', True),
        ('NO', False),
        ('tRue', 'tRue'),
        ('null', None),
        ('~', None),
        ('a/b.c', 'a/b.c'),
        ('-12', -12),
        ('012', 10),
        ('1.50', 1.5),
        ('-0.5', -0.5),
        ('1.', 1.0),
        ('1e3', '1e3'),
        ('[1, a]', [1, 'a']),
        ('{a: 1.5}', {'a': 1.5}),
        ("'12'", '12'),
        ('x' * 300, 'x' * 300),
    ],
)
def test_a_text_is_read_as_yaml(text: str, value: Any) -> None:
    assert (load_yaml_value(text), type(load_yaml_value(text))) == (value, type(value))


@given(st.one_of(st.integers(), st.floats(allow_nan=False, allow_infinity=False, width=32).map(lambda value: round(value, 3))))
def test_numbers_are_read_as_yaml_reads_them(value: float) -> None:
    assert load_yaml_value(str(value)) == yaml.safe_load(str(value))


def test_entities_are_flattened_and_texts_are_none() -> None:
    first, second, third = (LogInfo(msg=text) for text in 'abc')
    assert normalize_to_list_of_entities([first, [second, (third,)]]) == [first, second, third]
    assert normalize_to_list_of_entities(first) == [first]
    with pytest.raises(TypeError, match="given item of type '<class 'str'>', when only"):
        normalize_to_list_of_entities([first, ['a']])  # type: ignore[list-item]


def test_texts_become_substitutions() -> None:
    conf = LaunchConfiguration('x', default='y')
    assert normalize_to_list_of_substitutions(conf) == [conf]
    assert perform_substitutions(LaunchContext(), normalize_to_list_of_substitutions(['a', conf, 'b'])) == 'ayb'
    one = normalize_to_list_of_substitutions('a')
    assert [plain_text(value) for value in ('a', one, tuple(one), [*one, *one], [conf], 5)] == ['a', 'a', 'a', None, None, None]
    with pytest.raises(TypeError, match="given item of type '<class 'int'>'"):
        normalize_to_list_of_substitutions(['a', 5])  # type: ignore[list-item]

"""Typed values. (`typing.List` is what ROS 2 users write.)"""
# ruff: noqa: UP006, UP035

from __future__ import annotations

from typing import Any, List

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch.utilities._yaml_values import load_yaml_value
from launch.utilities.type_utils import (
    coerce_list,
    coerce_to_type,
    extract_type,
    get_typed_value,
    is_instance_of,
    is_normalized_substitution,
    is_substitution,
    is_valid_scalar_type,
    normalize_typed_substitution,
    perform_typed_substitution,
)


@pytest.mark.parametrize(
    ('text', 'data_type', 'value'),
    [
        ('asd', str, 'asd'),
        ('1', int, 1),
        ('1.5', float, 1.5),
        ('1', bool, True),
        ('off', bool, False),
        ('True', bool, True),
        ('[1, 2]', List[int], [1, 2]),
        ('[a, b]', List[str], ['a', 'b']),
        ('[.2, .1]', List[float], [0.2, 0.1]),
        ('', None, ''),
        ('1e3', None, '1e3'),
        ('yes', None, True),
        ('[1, 2]', None, [1, 2]),
        ('010', None, 8),
    ],
)
def test_texts_are_converted(text: str, data_type: Any, value: Any) -> None:
    converted = coerce_to_type(text, data_type)
    assert (converted, type(converted)) == (value, type(value))


@pytest.mark.parametrize(
    ('text', 'data_type', 'message'),
    [
        ('7', bool, "Cannot convert value '7' to '<class 'bool'>'"),
        ('1.5', int, "invalid literal for int() with base 10: '1.5'"),
        ('[1, 2]', List[float], "Cannot convert value '[1, 2]' to a list of '<class 'float'>', got [1, 2]"),
        ('{a: 1}', None, "Failed to convert '{a: 1}' using yaml rules: output type is not allowed, got <class 'dict'>"),
        ('x', dict, "Unrecognized data type: <class 'dict'>"),
    ],
)
def test_texts_that_cannot_be_converted(text: str, data_type: Any, message: str) -> None:
    with pytest.raises(ValueError) as error:
        coerce_to_type(text, data_type)
    assert str(error.value) == message


def test_a_text_may_stay_a_text() -> None:
    assert coerce_to_type('x', int, True) == 'x'
    assert get_typed_value(['1', 'x'], List[int]) == [1, 'x']
    assert coerce_list(['1', '2'], int) == [1, 2]
    assert [coerce_to_type('[x, 2.0]', kind, can_be_str=True) for kind in (None, List[float])] == [['x', 2.0]] * 2


@pytest.mark.parametrize(
    ('convert', 'value'),
    [
        (coerce_to_type, ['a']),
        (coerce_list, 'a'),
        (coerce_list, [1, 2]),
        (lambda value: get_typed_value(value, None), {'a'}),
        (lambda value: get_typed_value(value, int), ['1', '2']),
        (lambda value: perform_typed_substitution(LaunchContext(), value, int), 1.0),
        (lambda value: perform_typed_substitution(LaunchContext(), value, int), object),
    ],
)
def test_what_is_no_text_cannot_be_converted(convert: Any, value: Any) -> None:
    with pytest.raises(TypeError):
        convert(value)


def test_scalar_types() -> None:
    kinds = (int, float, bool, str, bytes, None, list, List[float])
    assert [is_valid_scalar_type(kind) for kind in kinds] == [True] * 4 + [False] * 4


@pytest.mark.parametrize(
    ('value', 'data_type', 'answer'),
    [(True, int, True), (1, float, False), ([1, 2], List[int], True), ([1, 'a'], None, False), ([1, 'a'], List[int], False)],
)
def test_instances(value: Any, data_type: Any, answer: bool) -> None:
    assert is_instance_of(value, data_type) is answer


def test_types_are_taken_apart() -> None:
    assert (extract_type(List[int]), extract_type(list[str]), extract_type(bool)) == ((int, True), (str, True), (bool, False))


def test_what_counts_as_a_substitution() -> None:
    text = TextSubstitution(text='a')
    assert [is_substitution(x) for x in (text, ['a', text], 'a', ['a'], [1, text])] == [True, True, False, False, False]
    assert [is_normalized_substitution(x) for x in ([text], [text, 'a'], [])] == [True, False, False]


@pytest.mark.parametrize(
    ('value', 'data_type', 'result'),
    [
        ([LaunchConfiguration('i'), '5'], int, 75),
        (['a', [LaunchConfiguration('i')]], List[str], ['a', '7']),
        ([[LaunchConfiguration('i')], 3], List[int], [7, 3]),
        (1.5, float, 1.5),
    ],
)
def test_substitutions_are_evaluated_and_converted(value: Any, data_type: Any, result: Any) -> None:
    context = LaunchContext()
    context.launch_configurations['i'] = '7'
    assert perform_typed_substitution(context, normalize_typed_substitution(value, data_type), data_type) == result


@given(st.text(alphabet='abcxyzn0123456789.-+_:~[]{}\'" eEtrufalso/#', max_size=8))
def test_the_short_way_agrees_with_yaml(text: str) -> None:
    try:
        expected = yaml.safe_load(text)
    except yaml.YAMLError:
        return
    found = load_yaml_value(text)
    assert repr(found) == repr(expected)

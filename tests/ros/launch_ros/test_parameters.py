"""What each kind of parameter value becomes: the measured table of ROS."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.utilities import evaluate_parameters, normalize_parameters

WRAP = (
    'If the parameter is meant to be a string, try wrapping it in '
    'launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)'
)


def evaluated(value: Any, text: str = '') -> Any:
    """The value of parameter p, with the launch configuration x set to `text`."""
    context = LaunchContext()
    context.launch_configurations['x'] = text
    (values,) = evaluate_parameters(context, normalize_parameters([{'p': value}]))
    return values['p']


X = LaunchConfiguration('x')


def test_the_list_of_a_parameter_value_stays_a_list() -> None:
    assert evaluated(ParameterValue(X, value_type=list[int]), '[1, 2]') == [1, 2]


@pytest.mark.parametrize(
    ('text', 'expected'),
    [
        ('7', 7),
        ('1.5', 1.5),
        ('true', True),
        ('yes', True),
        ('no', False),
        ('off', False),
        ('', ''),
        ('abc', 'abc'),
        ('[1, 2]', (1, 2)),
        ('[a, b]', ('a', 'b')),
        ("'5'", '5'),
        ('0x10', 16),
        ('010', 8),
        ('1_000', 1000),
        ('1e3', '1e3'),
        ('1.0e+3', 1000.0),
        ('.inf', math.inf),
        ('-3', -3),
    ],
)
def test_texts_of_substitutions_are_typed_by_yaml(text: str, expected: Any) -> None:
    found = evaluated(X, text)
    assert (found, type(found)) == (expected, type(expected))


@pytest.mark.parametrize(
    ('value', 'expected'),
    [
        (1, 1),
        (True, True),
        ('true', 'true'),
        ('1', '1'),
        ('', ''),
        (b'x', b'x'),
        ([1, 2], (1, 2)),
        ([1, 2.5], (1.0, 2.5)),
        ([True, False], (True, False)),
        (['1', '2'], ('1', '2')),
        ([1, True], (1, True)),
        (['a', X], 'a7'),
        ([[X], [X]], (7, 7)),
        ([['a', X], 'x'], ('a7', 'x')),
        ([[X], '1'], None),
    ],
)
def test_literals_keep_their_type_and_lists_with_substitutions_are_joined(value: Any, expected: Any) -> None:
    if expected is None:
        with pytest.raises(TypeError, match='Got inconsistent input for "p"'):
            evaluated(value, '7')
    else:
        assert evaluated(value, '7') == expected


@pytest.mark.parametrize(
    ('value', 'text', 'message'),
    [
        (X, '{a: 1}', f'Sequence[str]. Got <class \'dict\'> for "p". {WRAP}'),
        (X, '~', f'Sequence[str]. Got <class \'NoneType\'> for "p". {WRAP}'),
        (X, '2020-01-01', f'Sequence[str]. Got <class \'datetime.date\'> for "p". {WRAP}'),
        (X, '[1, 2', f'Unable to parse the value of parameter p as yaml. {WRAP}'),
        (X, 'a: b: c', f'Unable to parse the value of parameter p as yaml. {WRAP}'),
        (X, '[1, 2.0]', 'Got inconsistent input for "p"'),
        (X, '[]', 'Got inconsistent input for "p"'),
        ([1, 'a'], '', 'Got inconsistent input for "p"'),
        ([True, 1], '', 'Got inconsistent input for "p"'),
        ([], '', "but got '()' of type '<class 'tuple'>'"),
        (None, '', 'Unexpected type for parameter value None'),
    ],
)
def test_values_that_no_parameter_can_have_name_the_parameter(value: Any, text: str, message: str) -> None:
    with pytest.raises(TypeError) as caught:
        evaluated(value, text)
    assert str(caught.value).endswith(message)


def test_nested_mappings_become_dotted_names() -> None:
    nested = {'a': {'b': {'c': 1}, 'empty': {}}, (X, '.d'): 2}
    context = LaunchContext()
    context.launch_configurations['x'] = 'k'
    assert evaluate_parameters(context, normalize_parameters([nested])) == ({'a.b.c': 1, 'k.d': 2},)


def test_files_become_paths_and_order_is_kept(context: Any) -> None:
    parameter = Parameter('q', 3)
    items = ['a.yaml', Path('b.yaml'), b'c.yaml', ['d/', X], {'p': 1}, parameter]
    assert evaluate_parameters(context(x='e'), normalize_parameters(items)) == (
        Path('a.yaml'),
        Path('b.yaml'),
        Path('c.yaml'),
        Path('d/e'),
        {'p': 1},
        parameter,
    )


@pytest.mark.parametrize(
    ('value', 'kind', 'expected'),
    [
        (X, int, 7),
        (X, float, 7.0),
        (X, str, '7'),
        (X, None, 7),
        ([X, '5'], int, 75),
        ([1, 2], list[int], [1, 2]),
        (True, int, True),
    ],
)
def test_a_stated_type_decides(context: Any, value: Any, kind: Any, expected: Any) -> None:
    found = ParameterValue(value, value_type=kind).evaluate(context(x='7'))
    assert (found, type(found)) == (expected, type(expected))


def test_a_parameter_file_may_contain_substitutions(tmp_path: Path, context: Any) -> None:
    file = tmp_path / 'p.yaml'
    file.write_text('/**:\n  ros__parameters:\n    speed: $(var speed)\n', encoding='utf-8')
    described = ParameterFile(file, allow_substs=True)
    path = described.evaluate(context(speed='4'))
    assert path.read_text(encoding='utf-8') == '/**:\n  ros__parameters:\n    speed: 4\n'
    described.cleanup()
    assert not path.exists()


SCALARS = st.one_of(st.booleans(), st.integers(), st.floats(allow_nan=False), st.text(max_size=8))


@given(SCALARS)
def test_every_literal_scalar_is_passed_on_as_it_is(value: Any) -> None:
    assert evaluated(value) == value
    assert type(evaluated(value)) is type(value)


@given(st.text(max_size=12))
def test_a_text_wrapped_as_string_is_that_string_whatever_it_looks_like(text: str) -> None:
    assert evaluated(ParameterValue(TextSubstitution(text=text), value_type=str)) == text

"""edulaunch.engine.graph.parameters."""

from __future__ import annotations

import math
from array import array
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.graph import parameters as rules


@pytest.mark.parametrize(
    ('value', 'name'),
    [
        (None, 'NOT_SET'),
        (True, 'BOOL'),
        (1, 'INTEGER'),
        (1.0, 'DOUBLE'),
        ('a', 'STRING'),
        ([], 'BYTE_ARRAY'),
        ([b'a'], 'BYTE_ARRAY'),
        ([True], 'BOOL_ARRAY'),
        ((1, 2), 'INTEGER_ARRAY'),
        (array('d', [1.0]), 'DOUBLE_ARRAY'),
        (['a'], 'STRING_ARRAY'),
    ],
)
def test_types_are_inferred(value: Any, name: str) -> None:
    number = rules.type_of_value(value)
    assert rules.TYPE_NAMES[number] == name
    assert rules.value_fits(value, number)


@pytest.mark.parametrize(
    ('value', 'text'),
    [
        ([1, 2.0], "The given value is not a list of one of the allowed types '[1, 2.0]'."),
        ({}, "The given value is not one of the allowed types '{}'."),
    ],
)
def test_other_values_are_refused(value: Any, text: str) -> None:
    with pytest.raises(TypeError) as caught:
        rules.type_of_value(value)
    assert str(caught.value).startswith(text)


def test_an_integer_does_not_fit_a_double() -> None:
    assert not rules.value_fits(5, rules.DOUBLE)


@pytest.mark.parametrize(
    ('text', 'value'),
    [
        ('off', False),
        ('Y', True),
        ('5', 5),
        ('-5', -5),
        ('0x1F', 31),
        ('010', 8),
        ('08', 8.0),
        ('1e3', 1000.0),
        ('5.', 5.0),
        ('.inf', math.inf),
        ('-.inf', -math.inf),
        ('1_000', '1_000'),
        ('~', '~'),
        ('null', 'null'),
        ('a b', 'a b'),
        ('99999999999999999999', 1e20),
        ('9223372036854775807', 2**63 - 1),
        ('9223372036854775808', 2.0**63),
        ('-9223372036854775808', -(2**63)),
        ('-9223372036854775809', -(2.0**63)),
        ('0o17', '0o17'),
        ('\N{FULLWIDTH DIGIT ONE}', '\N{FULLWIDTH DIGIT ONE}'),
    ],
)
def test_unquoted_scalars_are_read_as_c_and_yaml_1_1_do(text: str, value: Any) -> None:
    read = rules.scalar_from_text(text)
    assert (type(read), read) == (type(value), value)


@given(st.integers(-(1 << 63), (1 << 63) - 1))
def test_every_integer_survives_its_text(value: int) -> None:
    assert rules.scalar_from_text(str(value)) == value


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_float_survives_its_text(value: float) -> None:
    assert rules.scalar_from_text(repr(value)) == value


@given(st.integers(), st.integers(), st.integers(0, 5), st.integers())
def test_integer_ranges_allow_their_ends_and_steps_only(lowest: int, width: int, step: int, value: int) -> None:
    highest = lowest + abs(width)
    allowed = value in (lowest, highest) or (lowest < value < highest and (not step or (value - lowest) % step == 0))
    assert (rules.integer_range_problem('p', value, lowest, highest, step) is None) == allowed


def test_range_texts() -> None:
    assert rules.integer_range_problem('p', 300, 0, 255, 1) == 'Parameter p out of range. Min: 0, Max: 255, value: 300'
    assert rules.float_range_problem('p', 3.0, 0.0, 1.0, 0.0) == 'Parameter p out of range Min: 0.0, Max: 1.0, value: 3.0'
    assert (rules.integer_range_problem('p', 3, 0, 10, 2) or '').startswith(
        'The parameter value for p is not a valid step. Min: '
    )


def test_float_ends_and_steps_have_a_tolerance() -> None:
    assert rules.float_range_problem('p', 1.0000000001, 0.0, 1.0, 0.0) is None
    assert rules.float_range_problem('p', 0.1 + 0.2, 0.0, 1.0, 0.1) is None
    assert rules.float_range_problem('p', 1.0000009, 0.0, 1.0, 0.0) is None
    assert rules.float_range_problem('p', 1.0000011, 0.0, 1.0, 0.0) is not None


@pytest.mark.parametrize(
    ('pattern', 'name', 'matches'),
    [
        ('/sim', '/sim', True),
        ('/sim', '/ns/sim', False),
        ('/**', '/ns/sim', True),
        ('/*/sim', '/ns/sim', True),
        ('/*/sim', '/sim', False),
        ('/**/sim', '/a/b/sim', True),
        ('/**/sim', '/sim', True),
        ('/*', '/a/b', False),
    ],
)
def test_node_patterns(pattern: str, name: str, matches: bool) -> None:
    assert rules.pattern_matches(pattern, name) is matches

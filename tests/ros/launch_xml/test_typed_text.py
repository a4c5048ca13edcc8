"""Typed values from texts."""

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from launch_xml.entity import typed

from tests.house import EXAMPLES


@pytest.mark.parametrize(
    ('text', 'data_type', 'value'),
    [
        ('1', None, 1),
        ('1.5', None, 1.5),
        ('true', None, True),
        ('Off', None, False),
        ('a', None, 'a'),
        ('', None, ''),
        ('$(var x)', None, '$(var x)'),
        ("'5'", None, '5'),
        ('[1, 2]', None, [1, 2]),
        ('a: b', None, 'a: b'),
        ('null', None, 'null'),
        ('~', None, '~'),
        ('2020-01-01', None, '2020-01-01'),
        ('5', int, 5),
        ('5', float, 5.0),
        ('5', str, '5'),
        ('1', bool, True),
        ('$(var x)', int, '$(var x)'),
    ],
)
def test_a_text_becomes_what_the_type_says(text, data_type, value):
    result = typed(text, data_type, True)
    assert (result, type(result)) == (value, type(value))


def test_a_text_that_is_not_convertible_is_an_error_when_texts_are_not_allowed():
    with pytest.raises(ValueError, match='yes please'):
        typed('yes please', bool, False)


@settings(max_examples=2 * EXAMPLES)
@given(st.text('abT$_/ .,:#-[]{}()!"\'0123456789~=<>|&*%@', min_size=1) | st.sampled_from(['NULL', 'On', 'nO', 'y']))
def test_the_quick_way_agrees_with_yaml(text):
    try:
        loaded = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError):
        loaded = text
    # What YAML reads as something that launch does not allow stays a text.
    if isinstance(loaded, (int, float, str)):
        result = typed(text, None, True)
        assert (repr(result), type(result)) == (repr(loaded), type(loaded))

import pytest

from edulaunch.interfaces.literals import constant_value, default_value
from edulaunch.interfaces.spec import FieldType


@pytest.mark.parametrize(
    ('base', 'text', 'value'),
    [
        ('bool', 'true', True),
        ('bool', '0', False),
        ('byte', '2', b'\x02'),
        ('int8', '-128', -128),
        ('float32', '1e3', 1000.0),
        ('string', "'it\\'s'", "it's"),
        ('string', 'bare words', 'bare words'),
        ('string', '', ''),
    ],
)
def test_constants_have_the_value_of_their_type(base, text, value):
    assert constant_value(base, text) == value


@pytest.mark.parametrize(
    ('field_type', 'text', 'value'),
    [
        (FieldType('int32', None, 'unbounded'), '[1, 2]', (1, 2)),
        (FieldType('bool', None, 'fixed', 2), '[true, false]', (True, False)),
        (FieldType('string', None, 'bounded', 3), '["a, b", \'c\']', ('a, b', 'c')),
        (FieldType('float64', None, 'unbounded'), '[]', ()),
    ],
)
def test_list_defaults_stand_in_brackets(field_type, text, value):
    assert default_value(field_type, text) == value


@pytest.mark.parametrize(
    ('field_type', 'text', 'expected'),
    [
        (FieldType('int32'), '1.5', 'a whole number, not 1.5'),
        (FieldType('uint8'), '256', 'a whole number in [0, 255], not 256'),
        (FieldType('bool'), 'yes', 'true or false, not yes'),
        (FieldType('float64'), 'x', 'a number, not x'),
        (FieldType('string', 2), 'abc', 'at most 2 characters, not 3'),
        (FieldType('int8', None, 'fixed', 3), '[1]', '3 values, not 1'),
        (FieldType('int8', None, 'bounded', 1), '[1, 2]', 'at most 1 values, not 2'),
        (FieldType('int8', None, 'unbounded'), '1', 'a list in brackets such as [1, 2], not 1'),
        (FieldType('string'), '"a', 'a closing " on the same line (ROS cuts a line at #, even inside quotes)'),
        (FieldType('string'), '"a"b"', 'one quoted string with a backslash before each inner ", not "a"b"'),
    ],
)
def test_a_wrong_default_says_what_was_expected(field_type, text, expected):
    with pytest.raises(ValueError) as caught:
        default_value(field_type, text)
    assert str(caught.value) == expected

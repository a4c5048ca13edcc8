import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.interfaces.notation import Line, constant_value, default_value, field_type, sections_of, split_type
from edulaunch.engine.interfaces.spec import FieldType
from edulaunch.errors import InterfaceError

SIZES = st.integers(1, 999)


@given(
    st.sampled_from(['int32', 'string', 'p/msg/T']),
    st.none() | SIZES,
    st.sampled_from(['', 'fixed', 'bounded', 'unbounded']),
    SIZES,
)
def test_the_text_of_a_type_reads_back_as_the_type(base, bound, array, size):
    one = FieldType(base, bound, array, size if array in ('fixed', 'bounded') else 0)
    assert split_type(one.text) == one


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('int32[', "'int32[' is not a type"),
        ('int32<=3', "only strings have a bound, not 'int32'"),
        ('int32[0]', "'int32[0]' has room for nothing: a size must be at least 1"),
        ('point', "unknown type 'point'"),
        ('a/b/c/D', "unknown type 'a/b/c/D'"),
    ],
)
def test_a_wrong_type_is_named(text, message):
    with pytest.raises(InterfaceError) as caught:
        field_type(Line('f', 7, ''), text, 'p')
    assert caught.value.message == f'f:7: {message}'


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


def test_comments_and_blank_lines_are_left_out_but_counted():
    [[line]] = sections_of('# note\n\n  int8 a # why\n', 'f', 'msg', 1)
    assert (line.number, line.text) == (3, 'int8 a')


@pytest.mark.parametrize(
    ('text', 'kind', 'wanted', 'message'),
    [
        (
            'int8 a',
            'srv',
            2,
            (
                "f.srv:1: expected 1 more line with '---'\n  help: a .srv file has these parts, which may be empty: request --- response"
            ),
        ),
        (
            '',
            'action',
            3,
            (
                "f.action:1: expected 2 more lines with '---'\n"
                '  help: a .action file has these parts, which may be empty: goal --- result --- feedback'
            ),
        ),
        ('---', 'msg', 1, "f.msg:1: a .msg file has no line with '---'; this is one too many"),
        ('---\n---', 'srv', 2, "f.srv:2: a .srv file has 1 line with '---'; this is one too many"),
        ('----', 'srv', 2, "f.srv:1: expected '---' alone on its line, not '----'"),
    ],
)
def test_the_number_of_parts_must_fit_the_kind(text, kind, wanted, message):
    with pytest.raises(InterfaceError) as caught:
        sections_of(text, f'f.{kind}', kind, wanted)
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ('text', 'base', 'rest'),
    [
        ('Header', 'std_msgs/msg/Header', (None, '', 0)),
        ('Point', 'p/msg/Point', (None, '', 0)),
        ('other_msgs/Point[]', 'other_msgs/msg/Point', (None, 'unbounded', 0)),
        ('other_msgs/msg/Point[<=3]', 'other_msgs/msg/Point', (None, 'bounded', 3)),
        ('char[1]', 'uint8', (None, 'fixed', 1)),
        ('wstring<=1', 'wstring', (1, '', 0)),
    ],
)
def test_a_type_has_its_full_name(text, base, rest):
    assert field_type(Line('f', 7, ''), text, 'p') == FieldType(base, *rest)


@pytest.mark.parametrize(
    ('text', 'help'),
    [
        ('double', 'float64'),
        ('int', 'int32 or int64'),
        ('str', 'string'),
        ('boolean', 'bool'),
        ('duration', 'builtin_interfaces/Duration'),
        ('time', 'builtin_interfaces/Time'),
        ('list', 'T[], such as int32[]'),
        ('flaot32', "did you mean 'float32'?"),
    ],
)
def test_a_type_of_another_language_has_the_one_of_ros(text, help):
    with pytest.raises(InterfaceError) as caught:
        field_type(Line('f', 7, ''), text, 'p')
    assert help in str(caught.value.help)


@pytest.mark.parametrize('text', ['string<=0', 'string[<=0]', 'string<=0[3]'])
def test_a_size_is_at_least_one(text):
    with pytest.raises(InterfaceError, match='has room for nothing: a size must be at least 1'):
        field_type(Line('f', 7, ''), text, 'p')


@pytest.mark.parametrize(
    ('base', 'text', 'value'),
    [
        ('bool', 'FALSE', False),
        ('bool', '1', True),
        ('int32', '0x10', 16),
        ('uint8', '255', 255),
        ('float32', 'inf', float('inf')),
        ('float32', '3.4e38', 3.4e38),
        ('char', '7', 7),
        ('string', '"say \\"a\\""', 'say "a"'),
        ('string', "''", ''),
    ],
)
def test_constants_at_the_edges(base, text, value):
    assert constant_value(base, text) == value


@pytest.mark.parametrize(
    ('base', 'text', 'expected'),
    [
        ('float32', '1e39', 'a number in [-3.402823466e+38, 3.402823466e+38], not 1e39'),
        ('int8', '128', 'a whole number in [-128, 127], not 128'),
        ('string', "'", "a closing ' on the same line"),
    ],
)
def test_a_constant_outside_its_type(base, text, expected):
    with pytest.raises(ValueError) as caught:
        constant_value(base, text)
    assert str(caught.value).startswith(expected)


def test_sections_of_an_action_with_a_mark_of_its_encoding_and_old_line_ends():
    sections = sections_of('\ufeffint8 a\r\n---\rint8\tb # c\n---\n', 'f', 'action', 3)
    assert [[(line.number, line.text) for line in section] for section in sections] == [[(1, 'int8 a')], [(3, 'int8 b')], []]

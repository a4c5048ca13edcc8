import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.interfaces.parser import parse
from edulaunch.engine.interfaces.spec import Constant, Field, FieldType
from edulaunch.errors import InterfaceError


def fields(text):
    return parse(text, 'my_msgs/msg/Num').fields


def error(text, type_name='my_msgs/msg/Num', file='src/Num.msg'):
    with pytest.raises(InterfaceError) as caught:
        parse(text, type_name, file)
    return str(caught.value)


def test_a_field_has_a_name_a_type_and_its_line():
    assert fields('\nfloat64 x # metres\n') == (Field('x', FieldType('float64'), None, 2),)


def test_defaults_follow_the_name_and_constants_have_an_equals_sign():
    spec = parse('int32 a 3\nint32 MAX=0x10\nstring WORD="it is"\nstring BARE= no quotes \n', 'p/msg/T')
    assert spec.fields[0].default == 3
    assert spec.constants == (
        Constant('MAX', 'int32', 16),
        Constant('WORD', 'string', 'it is'),
        Constant('BARE', 'string', 'no quotes'),
    )


def test_a_default_may_contain_an_equals_sign():
    assert fields("string s 'a = b'")[0].default == 'a = b'


@pytest.mark.parametrize(
    ('written', 'base'),
    [
        ('Point', 'my_msgs/msg/Point'),
        ('geometry_msgs/Point', 'geometry_msgs/msg/Point'),
        ('geometry_msgs/msg/Point', 'geometry_msgs/msg/Point'),
        ('Header', 'std_msgs/msg/Header'),
        ('char', 'uint8'),
    ],
)
def test_type_names_are_resolved(written, base):
    assert fields(f'{written} a')[0].type == FieldType(base)


def test_tabs_carriage_returns_marks_and_foreign_comments_are_no_matter():
    assert [field.name for field in fields('\ufefffloat64\tx\t# größe\r\n\r\nint8 y\r\n')] == ['x', 'y']


def test_a_service_has_two_parts_and_an_action_three():
    service = parse('int64 a\n---\nint64 b', 'p/srv/S')
    action = parse('---\nint64 b\n---\n', 'p/action/A')
    assert (service.request.type, service.response.fields[0].line) == ('p/srv/S_Request', 3)
    assert [part.type for part in action[1:]] == ['p/action/A_Goal', 'p/action/A_Result', 'p/action/A_Feedback']


@pytest.mark.parametrize(
    ('text', 'message'),
    [
        ('int32 a\nint x', "src/Num.msg:2: unknown type 'int'\n  help: did you mean int32 or int64?"),
        ('flaot32 x', "src/Num.msg:1: unknown type 'flaot32'\n  help: did you mean 'float32'?"),
        ('float64', "src/Num.msg:1: expected a type and a name, such as 'float64 x', not 'float64'"),
        (
            'int32 firstName',
            (
                "src/Num.msg:1: 'firstName' is an invalid field name. It should have the pattern "
                "'^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$'\n"
                '  help: lower-case letters, digits and single underscores, starting with a letter'
            ),
        ),
        (
            'int32 x=3',
            (
                "src/Num.msg:1: 'x' is an invalid constant name. It should have the pattern "
                "'^[A-Z]([A-Z0-9_]?[A-Z0-9]+)*$'\n"
                "  help: write X for a constant, or leave out the '=' for a default value"
            ),
        ),
        (
            'int32[2] X=3',
            (
                "src/Num.msg:1: a constant must have a primitive type, not 'int32[2]'\n"
                '  help: a default has no =: int32[] values [1, 2]'
            ),
        ),
        (
            'Point p 3',
            (
                "src/Num.msg:1: field 'p' of type 'my_msgs/msg/Point' cannot have a default\n"
                '  help: only primitive types have defaults'
            ),
        ),
        ('uint8 A=300', "src/Num.msg:1: constant 'A' of type 'uint8' expected a whole number in [0, 255], not 300"),
        ('int8 a\nint8 a', "src/Num.msg:2: 'a' is already the name of line 1"),
        (
            'int8 class',
            (
                "src/Num.msg:1: 'class' cannot be a name here: it is a word of Python\n"
                "  help: choose another, such as 'class_value'"
            ),
        ),
    ],
)
def test_errors_name_file_line_and_what_was_expected(text, message):
    assert error(text) == message


def test_a_long_constant_name_is_refused_quickly():
    assert 'invalid constant name' in error(f'int32 {"A" * 200}a=1')


LINE = st.one_of(st.text(), st.from_regex(r'[a-zA-Z0-9/<=\[\]]{1,12} [a-zA-Z_]{1,6}( |=)[-0-9a-z\[\]\'",.]{0,9}'), st.just('---'))


@given(st.lists(LINE).map('\n'.join), st.sampled_from(['msg', 'srv', 'action']))
def test_any_text_is_an_interface_or_an_interface_error(text, kind):
    try:
        parse(text, f'p/{kind}/T')
    except InterfaceError as problem:
        assert problem.message.startswith(f'p/{kind}/T:')

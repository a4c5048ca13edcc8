import pytest

from edulaunch.engine.interfaces.layout import default_wire, is_byte_like, is_fixed_numbers, is_number_sequence, zero
from edulaunch.engine.interfaces.spec import Field, FieldType


def test_nested_fields_lie_in_place_of_the_nested_message(get):
    assert [leaf.path for leaf in get('geometry_msgs/msg/TransformStamped').LAYOUT.leaves] == [
        'header.stamp.sec',
        'header.stamp.nanosec',
        'header.frame_id',
        'child_frame_id',
        'transform.translation.x',
        'transform.translation.y',
        'transform.translation.z',
        'transform.rotation.x',
        'transform.rotation.y',
        'transform.rotation.z',
        'transform.rotation.w',
    ]


@pytest.mark.parametrize(
    ('field', 'wire'),
    [
        (Field('a', FieldType('float64')), 0.0),
        (Field('a', FieldType('byte')), b'\0'),
        (Field('a', FieldType('string'), 'x'), 'x'),
        (Field('a', FieldType('uint8', None, 'fixed', 3)), b'\0\0\0'),
        (Field('a', FieldType('int8', None, 'unbounded'), (-1, 1)), b'\xff\1'),
        (Field('a', FieldType('float64', None, 'fixed', 2)), (0.0, 0.0)),
        (Field('a', FieldType('float64', None, 'fixed', 1), (0.1,)), (0.1,)),
        (Field('a', FieldType('float32', None, 'fixed', 1), (0.1,)), (0.10000000149011612,)),
        (Field('a', FieldType('bool', None, 'bounded', 2)), ()),
    ],
)
def test_a_field_never_set_has_a_default_on_the_wire(field, wire):
    assert default_wire(field) == wire


def test_a_leaf_knows_its_message_and_its_slot(get):
    layout = get('geometry_msgs/msg/PoseStamped').LAYOUT
    assert [(branch.variable, branch.holder, branch.slot, branch.type) for branch in layout.branches] == [
        ('b0', 'm', '_header', 'std_msgs/msg/Header'),
        ('b1', 'b0', '_stamp', 'builtin_interfaces/msg/Time'),
        ('b2', 'm', '_pose', 'geometry_msgs/msg/Pose'),
        ('b3', 'b2', '_position', 'geometry_msgs/msg/Point'),
        ('b4', 'b2', '_orientation', 'geometry_msgs/msg/Quaternion'),
    ]
    sec = layout.leaves[0]
    assert (sec.path, sec.holder, sec.owner, sec.target) == ('header.stamp.sec', 'b1', 'builtin_interfaces/msg/Time', 'b1._sec')
    other = sec.held_by('x')
    assert (other.path, other.owner, other.target, other.type.base) == (sec.path, sec.owner, 'x._sec', 'int32')


@pytest.mark.parametrize(
    ('field_type', 'answers'),
    [
        (FieldType('uint8', None, 'unbounded'), (True, False, True)),
        (FieldType('byte', None, 'fixed', 2), (True, False, False)),
        (FieldType('float64', None, 'fixed', 2), (False, True, False)),
        (FieldType('int32', None, 'bounded', 2), (False, False, True)),
        (FieldType('string', None, 'fixed', 2), (False, False, False)),
        (FieldType('geometry_msgs/msg/Point', None, 'fixed', 2), (False, False, False)),
        (FieldType('uint8'), (False, False, False)),
    ],
)
def test_what_readers_of_a_repeated_field_get(field_type, answers):
    assert (is_byte_like(field_type), is_fixed_numbers(field_type), is_number_sequence(field_type)) == answers


@pytest.mark.parametrize(('base', 'value'), [('bool', False), ('int8', 0), ('float32', 0.0), ('string', ''), ('byte', b'\0')])
def test_an_element_that_was_never_set(base, value):
    assert (zero(FieldType(base)), type(zero(FieldType(base)))) == (value, type(value))


def test_bytes_of_a_default_and_elements_without_one():
    assert default_wire(Field('a', FieldType('byte', None, 'fixed', 2), (b'\1', b'\2'))) == b'\1\2'
    with pytest.raises(ValueError, match='the elements of a nested field have no plain default'):
        default_wire(Field('a', FieldType('geometry_msgs/msg/Point', None, 'fixed', 2)))

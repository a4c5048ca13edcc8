import pytest

from edulaunch.engine.interfaces.layout import default_wire
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

import pytest

from edulaunch.interfaces.spec import FieldType


@pytest.mark.parametrize(
    ('field_type', 'ros'),
    [
        (FieldType('float64'), 'double'),
        (FieldType('float32', None, 'unbounded'), 'sequence<float>'),
        (FieldType('bool'), 'boolean'),
        (FieldType('byte'), 'octet'),
        (FieldType('string', 10), 'string<10>'),
        (FieldType('uint8', None, 'bounded', 5), 'sequence<uint8, 5>'),
        (FieldType('float64', None, 'fixed', 36), 'double[36]'),
        (FieldType('geometry_msgs/msg/Vector3'), 'geometry_msgs/Vector3'),
        (FieldType('string', 4, 'bounded', 2), 'sequence<string<4>, 2>'),
    ],
)
def test_types_are_shown_as_ros_shows_them(field_type, ros):
    assert field_type.ros_text == ros

from array import array
from struct import calcsize

import pytest

from edulaunch.engine.interfaces.spec import KINDS, FieldType, module_name, primitive_name
from edulaunch.engine.nearest import did_you_mean, nearest


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


NUMBERS = [kind for kind in KINDS.values() if kind.is_number]


@pytest.mark.parametrize('kind', NUMBERS, ids=lambda kind: kind.name)
def test_the_code_of_a_number_has_its_size_in_struct_and_array(kind):
    assert (calcsize(f'<{kind.code}'), array(kind.code).itemsize) == (kind.size, kind.size)


def test_ranges_are_worded_as_ros_words_them():
    assert KINDS['int32'].range_words == 'integer in [-2147483648, 2147483647]'
    assert KINDS['uint8'].range_words == 'unsigned integer in [0, 255]'
    assert KINDS['float32'].range_words == 'float in [-3.402823466e+38, 3.402823466e+38]'


def test_char_is_uint8():
    assert primitive_name('char') == 'uint8'


@pytest.mark.parametrize(
    ('name', 'module'),
    [
        ('TransformStamped', 'transform_stamped'),
        ('TFMessage', 'tf_message'),
        ('TF2Error', 'tf2_error'),
        ('Pose2D', 'pose2_d'),
        ('ColorRGBA', 'color_rgba'),
        ('UUID', 'uuid'),
        ('Int32MultiArray', 'int32_multi_array'),
    ],
)
def test_modules_are_named_as_ros_names_them(name, module):
    assert module_name(name) == module


def test_the_nearest_name_disregards_case_and_far_names_are_none():
    assert nearest('twist', ['Pose', 'Twist']) == 'Twist'
    assert did_you_mean('xyz', ['Pose', 'Twist']) is None


def test_a_bool_and_a_byte_take_one_byte_and_have_these_limits():
    shown = [(kind.python, kind.size, kind.low, kind.high) for kind in (KINDS['bool'], KINDS['byte'])]
    assert shown == [(bool, 1, 0, 1), (bytes, 1, 0, 255)]

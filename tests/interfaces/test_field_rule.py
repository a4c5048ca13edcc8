from array import array
from enum import IntEnum

import numpy
import pytest

DOUBLES = '[-1.7976931348623157e+308, 1.7976931348623157e+308]'
EACH_DOUBLE = f"each value of type 'float' and each double in {DOUBLES}"
SEVERAL = 'field must be a set or sequence'


@pytest.mark.parametrize(
    ('type_name', 'field', 'value', 'text'),
    [
        ('geometry_msgs/msg/Point', 'x', 2, "The 'x' field must be of type 'float'"),
        ('geometry_msgs/msg/Point', 'x', numpy.float32(2), "The 'x' field must be of type 'float'"),
        ('std_msgs/msg/String', 'data', 2, "The 'data' field must be of type 'str'"),
        ('std_msgs/msg/Bool', 'data', 1, "The 'data' field must be of type 'bool'"),
        ('std_msgs/msg/Int32', 'data', numpy.int64(2), "The 'data' field must be of type 'int'"),
        (
            'std_msgs/msg/Byte',
            'data',
            b'ab',
            "The 'data' field must be of type 'bytes' or 'ByteString' with length 1",
        ),
        (
            'geometry_msgs/msg/Twist',
            'linear',
            2.0,
            "The 'linear' field must be a sub message of type 'Vector3'",
        ),
        (
            'builtin_interfaces/msg/Time',
            'sec',
            2**31,
            "The 'sec' field must be an integer in [-2147483648, 2147483647]",
        ),
        ('turtlesim/msg/Color', 'r', 256, "The 'r' field must be an unsigned integer in [0, 255]"),
        (
            'turtlesim/msg/Pose',
            'x',
            4e38,
            "The 'x' field must be a float in [-3.402823466e+38, 3.402823466e+38]",
        ),
        (
            'type_description_interfaces/msg/FieldType',
            'nested_type_name',
            'x' * 256,
            "The 'nested_type_name' field must be string value not longer than 255",
        ),
        (
            'geometry_msgs/msg/PoseWithCovariance',
            'covariance',
            [0.0] * 35,
            f"The 'covariance' {SEVERAL} with length 36 and {EACH_DOUBLE}",
        ),
        (
            'geometry_msgs/msg/PoseWithCovariance',
            'covariance',
            numpy.zeros(35),
            "The 'covariance' numpy.ndarray() must have a size of 36",
        ),
        (
            'geometry_msgs/msg/PoseWithCovariance',
            'covariance',
            numpy.zeros(36, 'float32'),
            "The 'covariance' numpy.ndarray() must have the dtype of 'numpy.float64'",
        ),
        (
            'sensor_msgs/msg/LaserScan',
            'ranges',
            array('d'),
            "The 'ranges' array.array() must have the type code of 'f'",
        ),
        (
            'shape_msgs/msg/SolidPrimitive',
            'dimensions',
            [0.0] * 4,
            f"The 'dimensions' {SEVERAL} with length <= 3 and {EACH_DOUBLE}",
        ),
        (
            'std_msgs/msg/UInt8MultiArray',
            'data',
            'abc',
            f"The 'data' {SEVERAL} and each value of type 'int' and each unsigned integer in [0, 255]",
        ),
        (
            'tf2_msgs/msg/TFMessage',
            'transforms',
            3,
            f"The 'transforms' {SEVERAL} and each value of type 'TransformStamped'",
        ),
    ],
)
def test_a_wrong_value_is_refused_in_rclpys_words(get, type_name, field, value, text):
    with pytest.raises(AssertionError) as caught:
        setattr(get(type_name)(), field, value)
    assert str(caught.value).split('\n  help: ')[0] == text
    assert '\n  help: ' in str(caught.value)


def test_numpy_doubles_are_floats_and_are_stored_as_such(get):
    msg = get('geometry_msgs/msg/Point')(x=numpy.float64(2.5))
    assert (type(msg.x), msg.x) == (float, 2.5)


def test_an_enumeration_member_is_stored_as_its_number(get):
    msg = get('std_msgs/msg/Int32')(data=IntEnum('Level', 'LOW HIGH').HIGH)
    assert (type(msg.data), msg.data) == (int, 2)


@pytest.mark.parametrize('value', [[1.0, 2.0], (1.0, 2.0), array('f', [1.0, 2.0])])
def test_lists_tuples_and_arrays_become_arrays(get, value):
    assert get('sensor_msgs/msg/LaserScan')(ranges=value).ranges == array('f', [1.0, 2.0])


def test_a_fixed_array_can_be_given_as_a_matrix(get):
    cls = get('geometry_msgs/msg/PoseWithCovariance')
    assert cls.to_wire(cls(covariance=numpy.eye(6)))[7][:8] == (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def test_bytes_are_a_sequence_of_uint8(get):
    assert get('sensor_msgs/msg/Image')(data=b'\1\2').data == array('B', [1, 2])

from array import array
from enum import IntEnum

import numpy
import pytest

from edulaunch.engine.facts import facts_of

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
        ('std_msgs/msg/Byte', 'data', b'ab', "The 'data' field must be of type 'bytes' or 'ByteString' with length 1"),
        ('geometry_msgs/msg/Twist', 'linear', 2.0, "The 'linear' field must be a sub message of type 'Vector3'"),
        ('builtin_interfaces/msg/Time', 'sec', 2**31, "The 'sec' field must be an integer in [-2147483648, 2147483647]"),
        ('turtlesim/msg/Color', 'r', 256, "The 'r' field must be an unsigned integer in [0, 255]"),
        ('turtlesim/msg/Pose', 'x', 4e38, "The 'x' field must be a float in [-3.402823466e+38, 3.402823466e+38]"),
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
            numpy.zeros(36, 'complex'),
            "The 'covariance' numpy.ndarray() must have the dtype of 'numpy.float64'",
        ),
        (
            'shape_msgs/msg/SolidPrimitive',
            'dimensions',
            [0.0] * 4,
            f"The 'dimensions' {SEVERAL} with length <= 3 and {EACH_DOUBLE}",
        ),
        ('tf2_msgs/msg/TFMessage', 'transforms', 3, f"The 'transforms' {SEVERAL} and each value of type 'TransformStamped'"),
    ],
)
def test_a_wrong_value_is_refused_in_rclpys_words(get, type_name, field, value, text):
    with pytest.raises(AssertionError) as caught:
        setattr(get(type_name)(), field, value)
    assert str(caught.value) == text
    assert facts_of(caught.value)['about'] == 'messages.field-value'


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


@pytest.mark.parametrize(
    ('type_name', 'field', 'value', 'stored'),
    [
        ('sensor_msgs/msg/LaserScan', 'ranges', numpy.array([1.5, numpy.inf]), array('f', [1.5, float('inf')])),
        ('sensor_msgs/msg/LaserScan', 'ranges', numpy.array([1, 2], 'int32'), array('f', [1.0, 2.0])),
        ('sensor_msgs/msg/LaserScan', 'ranges', [numpy.float32(1), 2.0], array('f', [1.0, 2.0])),
        ('nav_msgs/msg/OccupancyGrid', 'data', numpy.array([-1, 100], 'int8'), array('b', [-1, 100])),
        ('nav_msgs/msg/OccupancyGrid', 'data', [numpy.int64(-1), 100], array('b', [-1, 100])),
        ('sensor_msgs/msg/Image', 'data', numpy.zeros((2, 2), 'uint8').flatten(), array('B', bytes(4))),
        ('sensor_msgs/msg/Image', 'data', numpy.array([]).astype('uint8'), array('B')),
        ('sensor_msgs/msg/Image', 'data', bytes([0, 255]), array('B', [0, 255])),
    ],
)
def test_a_sequence_of_numbers_takes_what_jazzys_array_takes_of_numpy(get, type_name, field, value, stored):
    msg = get(type_name)()
    setattr(msg, field, value)
    assert getattr(msg, field) == stored


@pytest.mark.parametrize(
    ('type_name', 'value', 'error', 'text'),
    [
        (
            'nav_msgs/msg/OccupancyGrid',
            numpy.array([1.0]),
            TypeError,
            "'numpy.float64' object cannot be interpreted as an integer",
        ),
        ('nav_msgs/msg/OccupancyGrid', numpy.array([200]), OverflowError, 'signed char is greater than maximum'),
        ('nav_msgs/msg/OccupancyGrid', numpy.zeros((2, 2), 'int8'), TypeError, 'scalar'),
        ('nav_msgs/msg/OccupancyGrid', array('d', [0.5]), TypeError, "'float' object cannot be interpreted as an integer"),
        ('std_msgs/msg/UInt8MultiArray', 'abc', TypeError, "cannot use a str to initialize an array with typecode 'B'"),
        ('std_msgs/msg/UInt8MultiArray', 3, TypeError, "'int' object is not iterable"),
        ('std_msgs/msg/UInt8MultiArray', [-1], OverflowError, 'unsigned byte integer is less than minimum'),
        ('std_msgs/msg/Float32MultiArray', numpy.array(['a']), TypeError, 'must be real number, not numpy.str_'),
        ('std_msgs/msg/Float32MultiArray', [1.0, None], TypeError, 'must be real number, not NoneType'),
        ('std_msgs/msg/Float32MultiArray', [10**400], OverflowError, 'int too large to convert to float'),
        ('std_msgs/msg/Float32MultiArray', b'12345', ValueError, 'bytes length not a multiple of item size'),
        ('test_msgs/msg/BoundedSequences', range(4), AssertionError, 'with length <= 3'),
    ],
)
def test_a_sequence_of_numbers_raises_what_the_array_of_python_raises(get, type_name, value, error, text):
    field = 'int32_values' if 'Bounded' in type_name else 'data'
    with pytest.raises(error, match=text) as caught:
        setattr(get(type_name)(), field, value)
    assert facts_of(caught.value)['about'] == 'messages.field-value'


@pytest.mark.parametrize(
    ('type_name', 'value', 'stored'),
    [
        ('std_msgs/msg/Float32MultiArray', [1.0, 1e39], array('f', [1.0, float('inf')])),
        ('std_msgs/msg/Float32MultiArray', bytes(4), array('f', [0.0])),
        ('std_msgs/msg/Int8MultiArray', bytes([200]), array('b', [-56])),
    ],
)
def test_a_sequence_of_numbers_takes_what_the_array_of_python_takes(get, type_name, value, stored):
    assert get(type_name)(data=value).data == stored


@pytest.mark.parametrize('value', [[0, 1.5, True], (0, 1.5, 1), array('d', [0, 1.5, 1]), numpy.array([0, 1.5, 1])])
def test_integers_are_floats_in_a_sequence_of_floats_as_in_jazzy(get, value):
    assert get('sensor_msgs/msg/JointState')(position=value).position == array('d', [0.0, 1.5, 1.0])
    covariance = get('geometry_msgs/msg/PoseWithCovariance')(covariance=[*value] * 12).covariance
    assert (covariance[:3].tolist(), covariance.dtype) == ([0.0, 1.5, 1.0], numpy.float64)


def test_an_array_of_another_kind_is_converted_as_in_jazzy(get):
    assert get('std_msgs/msg/Int64MultiArray')(data=array('B', [1, 2])).data == array('q', [1, 2])
    assert get('std_msgs/msg/Float64MultiArray')(data=map(int, '12')).data == array('d', [1.0, 2.0])
    assert get('sensor_msgs/msg/CameraInfo')(k=numpy.arange(9)).k.dtype == numpy.float64


def test_a_sequence_of_floats_may_hold_what_is_no_number(get):
    values = [float('nan'), 1.0, float('inf'), float('-inf')]
    assert list(map(repr, get('std_msgs/msg/Float32MultiArray')(data=values).data)) == ['nan', '1.0', 'inf', '-inf']


@pytest.mark.parametrize(
    ('type_name', 'field', 'good', 'bad'),
    [
        ('std_msgs/msg/Bool', 'data', True, 1),
        ('std_msgs/msg/Byte', 'data', b'a', b'ab'),
        ('geometry_msgs/msg/Twist', 'linear', None, 2.0),
    ],
)
def test_a_value_without_a_range_is_checked_by_its_class_alone(get, type_name, field, good, bad):
    message = get(type_name)()
    value = getattr(message, field) if good is None else good
    setattr(message, field, value)
    assert getattr(message, field) == value
    with pytest.raises(AssertionError, match=f"The '{field}' field must be"):
        setattr(message, field, bad)


def test_a_bounded_sequence_is_a_tuple_of_numbers_in_a_snapshot_and_refused_where_it_grew_too_long(get):
    message = get('shape_msgs/msg/SolidPrimitive')(type=1, dimensions=[1.0, 2.0])
    assert message.to_wire(message)[1] == (1.0, 2.0)
    message.dimensions.extend([3.0, 4.0])
    with pytest.raises(AssertionError, match='must have a size <= 3'):
        message.to_wire(message)


def test_what_was_appended_to_a_list_of_texts_is_checked_in_the_snapshot(get):
    message = get('sensor_msgs/msg/JointState')(name=['a', 'b'])
    message.name.append('c')
    assert message.to_wire(message)[3] == ('a', 'b', 'c')
    message.name.append(4)
    with pytest.raises(AssertionError, match="The 'name' field must be a set or sequence"):
        message.to_wire(message)


def test_what_was_appended_to_a_list_of_messages_is_checked_in_the_snapshot(get):
    message = get('tf2_msgs/msg/TFMessage')(transforms=[get('geometry_msgs/msg/TransformStamped')()])
    assert len(message.to_wire(message)[0]) == 1
    message.transforms.append(get('geometry_msgs/msg/Transform')())
    with pytest.raises(AssertionError, match="each value of type 'TransformStamped'"):
        message.to_wire(message)

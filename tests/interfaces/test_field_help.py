import numpy
import pytest


@pytest.mark.parametrize(
    ('type_name', 'field', 'value', 'help'),
    [
        ('geometry_msgs/msg/Point', 'x', 2, 'an int was given: write 2.0'),
        ('geometry_msgs/msg/Point', 'x', '2.5', 'a str was given: write float(value)'),
        ('geometry_msgs/msg/Point', 'x', 'far', 'a str was given'),
        ('geometry_msgs/msg/Point', 'x', None, 'None was given'),
        ('geometry_msgs/msg/Point', 'x', numpy.float32(1), 'a numpy.float32 was given: write float(value)'),
        ('std_msgs/msg/Bool', 'data', 1, 'an int was given: write bool(value)'),
        ('std_msgs/msg/Bool', 'data', 'no', 'a str was given'),
        ('std_msgs/msg/Byte', 'data', 7, 'an int was given: write bytes([7])'),
        ('turtlesim/msg/Color', 'r', 300, '300 was given'),
        (
            'geometry_msgs/msg/Twist',
            'linear',
            2.0,
            'a float was given: set its fields (linear.x, linear.y, linear.z) or assign a Vector3(...)',
        ),
        ('nav_msgs/msg/OccupancyGrid', 'data', [1, 2.0], 'a float is at index 1: write int(value)'),
        ('sensor_msgs/msg/LaserScan', 'ranges', 2.0, 'a float was given: write [2.0]'),
        (
            'sensor_msgs/msg/LaserScan',
            'ranges',
            numpy.zeros((2, 3)),
            'a numpy.ndarray was given with 2 dimensions: write value.ravel()',
        ),
        (
            'nav_msgs/msg/OccupancyGrid',
            'data',
            numpy.zeros(2),
            "a numpy.ndarray was given of 'float64': write value.astype('int8')",
        ),
        ('sensor_msgs/msg/JointState', 'name', numpy.array(['a', 'b']), 'a numpy.ndarray was given: write value.tolist()'),
        ('geometry_msgs/msg/PoseWithCovariance', 'covariance', [0.0], '1 value given'),
        ('std_msgs/msg/Int8MultiArray', 'data', [200], 'a value is out of range'),
    ],
)
def test_help_says_what_was_given_and_what_to_write(get, type_name, field, value, help):
    with pytest.raises(AssertionError) as caught:
        setattr(get(type_name)(), field, value)
    assert str(caught.value).split('\n  help: ')[1] == help


def test_help_names_the_message_that_was_given_instead(get):
    with pytest.raises(AssertionError, match='help: a geometry_msgs.msg.Point was given: set its fields'):
        get('geometry_msgs/msg/Twist')(linear=get('geometry_msgs/msg/Point')())

import array

import numpy
import pytest

from edulaunch.engine.facts import facts_of
from edulaunch.engine.interfaces.mistakes import field_facts, type_help, unknown_type


@pytest.mark.parametrize(
    ('type_name', 'field', 'value', 'facts'),
    [
        ('geometry_msgs/msg/Point', 'x', 2, {'wanted': 'float', 'given': 'int', 'write': '2.0'}),
        ('geometry_msgs/msg/Point', 'x', '2.5', {'given': 'str', 'write': 'float(value)'}),
        ('geometry_msgs/msg/Point', 'x', 'far', {'given': 'str', 'write': None}),
        ('geometry_msgs/msg/Point', 'x', None, {'given': 'None', 'write': None}),
        ('geometry_msgs/msg/Point', 'x', numpy.float32(1), {'given': 'numpy.float32', 'write': 'float(value)'}),
        ('geometry_msgs/msg/Point', 'x', (1, 5.0), {'given': 'tuple', 'write': None, 'commas': 2}),
        ('std_msgs/msg/Bool', 'data', 1, {'given': 'int', 'write': 'bool(value)'}),
        ('std_msgs/msg/Bool', 'data', 'no', {'given': 'str', 'write': None}),
        ('std_msgs/msg/Byte', 'data', 7, {'given': 'int', 'write': 'bytes([7])'}),
        ('turtlesim/msg/Color', 'r', 300, {'value': '300', 'write': None}),
        ('geometry_msgs/msg/Twist', 'linear', 2.0, {'wanted': 'Vector3', 'fields': ['linear.x', 'linear.y', 'linear.z']}),
        ('nav_msgs/msg/OccupancyGrid', 'data', [1, 2.0], {'field': 'data[1]', 'given': 'float', 'write': 'int(value)'}),
        ('sensor_msgs/msg/LaserScan', 'ranges', 2.0, {'wanted': 'float[]', 'given': 'float', 'write': '[2.0]'}),
        ('sensor_msgs/msg/LaserScan', 'ranges', numpy.zeros((2, 3)), {'given': 'numpy.ndarray', 'write': 'value.ravel()'}),
        (
            'nav_msgs/msg/OccupancyGrid',
            'data',
            numpy.zeros(2),
            {'given': 'numpy.ndarray(float64)', 'write': "value.astype('int8')"},
        ),
        ('sensor_msgs/msg/JointState', 'name', numpy.array(['a', 'b']), {'write': 'value.tolist()'}),
        ('geometry_msgs/msg/PoseWithCovariance', 'covariance', [0.0], {'count': 1, 'size': 36}),
        ('geometry_msgs/msg/PoseWithCovariance', 'covariance', numpy.zeros(3), {'count': 3, 'size': 36}),
        ('std_msgs/msg/Int8MultiArray', 'data', [200], {'value': '[200]'}),
        (
            'std_msgs/msg/Int8MultiArray',
            'data',
            array.array('d', [0.5]),
            {'given': "array('d')", 'write': "array.array('b', values)"},
        ),
    ],
)
def test_facts_say_what_was_given_and_what_to_write(get, type_name, field, value, facts):
    with pytest.raises((AssertionError, TypeError, OverflowError)) as caught:
        setattr(get(type_name)(), field, value)
    found = facts_of(caught.value)
    assert found['about'] == 'messages.field-value' and {name: found.get(name) for name in facts} == facts


def test_facts_name_the_message_that_was_given_instead(get):
    with pytest.raises(AssertionError) as caught:
        get('geometry_msgs/msg/Twist')(linear=get('geometry_msgs/msg/Point')())
    assert facts_of(caught.value)['given'] == 'geometry_msgs.msg.Point'


def facts_after(registry, action):
    with pytest.raises(AttributeError) as caught:
        action()
    found = field_facts(caught.value, registry)
    return (found['type'], found['near'], found['fields']) if found else None


def test_of_a_misspelt_field_the_nearest_is_known(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert facts_after(registry, lambda: setattr(msg, 'linaer', 1.0)) == ('Twist', 'linear', ['linear', 'angular'])
    assert facts_after(registry, lambda: msg.angluar) == ('Twist', 'angular', ['linear', 'angular'])


def test_of_a_far_name_the_fields_are_known(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert facts_after(registry, lambda: setattr(msg, 'q', 1.0)) == ('Twist', None, ['linear', 'angular'])
    empty = get('std_msgs/msg/Empty')()
    assert facts_after(registry, lambda: setattr(empty, 'data', 1.0)) == ('Empty', None, [])


def test_of_other_errors_nothing_is(registry):
    assert facts_after(registry, lambda: [].push) is None
    assert field_facts(ValueError("'Twist' object has no attribute 'x'"), registry) == {}


@pytest.mark.parametrize(
    ('name', 'help'),
    [
        ('std_msgs/msg/Twist', 'Twist is in geometry_msgs.msg'),
        ('turtlesim/msg/Spawn', "did you mean 'turtlesim/srv/Spawn'?"),
        ('geometry_msg/msg/Foo', "did you mean 'geometry_msgs'?"),
        ('zzz/msg/Foo', 'no package with interfaces has this name: is its workspace built and sourced?'),
    ],
)
def test_help_names_the_place_or_the_nearest_name(registry, name, help):
    assert type_help(registry, name) == help


def test_homes_are_import_paths(registry):
    assert registry.homes('SetBool') == ['example_interfaces.srv', 'std_srvs.srv']


def test_an_unknown_type_is_named_with_the_nearest_one(registry):
    assert (
        str(unknown_type(registry, 'geometry_msgs/msg/Twits'))
        == "unknown interface 'geometry_msgs/msg/Twits'\n  help: did you mean 'geometry_msgs/msg/Twist'?"
    )

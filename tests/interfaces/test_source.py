import math
from array import array

import pytest


def test_a_twist_is_flat_on_the_wire(get):
    twist = get('geometry_msgs/msg/Twist')
    msg = twist()
    msg.linear.x, msg.angular.z = 2.0, 1.8
    assert twist.to_wire(msg) == (2.0, 0.0, 0.0, 0.0, 0.0, 1.8)


def test_float32_values_are_rounded_on_the_wire(get):
    pose = get('turtlesim/msg/Pose')
    assert pose.to_wire(pose(x=5.5444445, theta=0.1)) == (5.544444561004639, 0.0, 0.10000000149011612, 0.0, 0.0)
    scan = get('sensor_msgs/msg/LaserScan')
    assert scan.to_wire(scan(angle_min=0.1, ranges=[0.1]))[3::7] == (0.10000000149011612, (0.10000000149011612,))


def test_repeated_messages_are_tuples_of_flat_tuples(get):
    cls, stamped = get('tf2_msgs/msg/TFMessage'), get('geometry_msgs/msg/TransformStamped')
    wire = cls.to_wire(cls(transforms=[stamped(child_frame_id='a')]))
    assert wire == (((0, 0, '', 'a', 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0),),)


def test_bytes_travel_as_bytes(get):
    image, uuid, octets = (
        get('sensor_msgs/msg/Image'),
        get('unique_identifier_msgs/msg/UUID'),
        get('std_msgs/msg/ByteMultiArray'),
    )
    assert image.to_wire(image(data=[1, 2]))[-1] == b'\1\2'
    assert uuid.to_wire(uuid(uuid=list(range(16)))) == (bytes(range(16)),)
    assert octets.from_wire(octets.to_wire(octets(data=[b'a', b'b']))).data == [b'a', b'b']


def test_a_snapshot_does_not_change_with_the_message(get):
    cls = get('sensor_msgs/msg/JointState')
    msg = cls(name=['a'], position=[1.0])
    wire = cls.to_wire(msg)
    msg.name.append('b')
    msg.position.append(2.0)
    assert wire[3:5] == (('a',), (1.0,))


def test_a_received_message_can_be_changed(get):
    cls = get('sensor_msgs/msg/JointState')
    msg = cls.from_wire((0, 0, '', ('a',), (1.0,), (), ()))
    msg.name.append('b')
    msg.position.append(2.0)
    assert (msg.name, msg.position) == (['a', 'b'], array('d', [1.0, 2.0]))


def test_every_class_gives_back_the_wire_it_was_made_from(message_classes, some_wires):
    for cls in message_classes:
        for wire in some_wires(cls):
            msg = cls.from_wire(wire)
            assert cls.to_wire(msg) == wire, cls.TYPE
            assert msg == cls.from_wire(wire), cls.TYPE


def test_reading_and_assigning_every_field_changes_nothing(message_classes, some_wires):
    for cls in message_classes:
        wire = some_wires(cls)[-1]
        msg, other = cls.from_wire(wire), cls()
        for name in cls.get_fields_and_field_types():
            setattr(other, name, getattr(msg, name))
        assert cls.to_wire(other) == wire, cls.TYPE


def test_every_class_starts_as_its_own_default_wire(message_classes):
    for cls in message_classes:
        assert cls.from_wire(cls.to_wire(cls())) == cls(), cls.TYPE


@pytest.mark.parametrize('value', [math.inf, -math.inf])
def test_infinity_is_a_float_of_both_sizes(get, value):
    for name in ('Float32', 'Float64'):
        cls = get(f'std_msgs/msg/{name}')
        assert cls.to_wire(cls(data=value)) == (value,)


def test_a_wire_of_another_length_is_refused(get):
    with pytest.raises(ValueError):
        get('geometry_msgs/msg/Point').from_wire((1.0, 2.0))


@pytest.mark.parametrize(
    ('type_name', 'field', 'wrong', 'words'),
    [
        ('geometry_msgs/msg/Polygon', 'points', 'x', "each value of type 'Point32'"),
        ('sensor_msgs/msg/JointState', 'name', 5, "each value of type 'str'"),
        ('std_msgs/msg/ByteMultiArray', 'data', 5, "each value of type 'bytes'"),
    ],
)
def test_something_wrong_appended_to_a_list_is_refused_when_sent(get, type_name, field, wrong, words):
    cls = get(type_name)
    msg = cls()
    getattr(msg, field).append(wrong)
    with pytest.raises(AssertionError, match=f"The '{field}' field must be a set or sequence and {words}"):
        cls.to_wire(msg)


def test_a_bounded_sequence_that_grew_too_long_is_refused_when_sent(get):
    cls = get('shape_msgs/msg/SolidPrimitive')
    msg = cls(dimensions=[1.0, 2.0, 3.0])
    msg.dimensions.append(4.0)
    with pytest.raises(AssertionError, match=r"The 'dimensions' array.array\(\) must have a size <= 3"):
        cls.to_wire(msg)

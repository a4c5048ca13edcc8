import pytest

from edulaunch.errors import InterfaceError
from edulaunch.interfaces import cdr


def test_the_bytes_of_a_twist_are_a_header_and_six_doubles(get):
    cls = get('geometry_msgs/msg/Twist')
    data = cdr.serialize(cls())
    assert data == bytes.fromhex('00010000') + bytes(48)
    assert cdr.deserialize(data, cls) == cls()


def test_every_wire_survives_cdr(message_classes, some_wires):
    for cls in message_classes:
        for wire in some_wires(cls):
            assert cdr.decode(cls, cdr.encode(cls, wire)) == wire, cls.TYPE


def test_every_message_has_the_bytes_that_rosbags_writes(registry, some_wires):
    typesys = pytest.importorskip('rosbags.typesys', reason='rosbags, the oracle, is not installed')
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    for name in registry.types('msg'):
        if name in store.fielddefs:
            cls = registry.get(name)
            for wire in some_wires(cls):
                data = cdr.encode(cls, wire)
                theirs = store.deserialize_cdr(data, name)
                assert bytes(store.serialize_cdr(theirs, name, little_endian=True)) == data, name


def test_the_values_that_rosbags_reads_are_ours(get):
    typesys = pytest.importorskip('rosbags.typesys', reason='rosbags, the oracle, is not installed')
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    msg = get('geometry_msgs/msg/TransformStamped')(child_frame_id='turtle1')
    msg.header.stamp.sec, msg.header.frame_id, msg.transform.translation.y = 5, 'world', 2.5
    theirs = store.deserialize_cdr(cdr.serialize(msg), 'geometry_msgs/msg/TransformStamped')
    assert (theirs.header.stamp.sec, theirs.header.frame_id, theirs.child_frame_id) == (5, 'world', 'turtle1')
    assert (theirs.transform.translation.y, theirs.transform.rotation.w) == (2.5, 1.0)


@pytest.mark.parametrize(
    ('data', 'text'),
    [
        (
            b'',
            (
                'these bytes are not little-endian CDR: they start with nothing\n'
                '  help: a std_msgs/msg/String starts with 00 01 00 00'
            ),
        ),
        (b'\0\1\0\0', 'these 4 bytes are not a std_msgs/msg/String: '),
        (
            b'\0\1\0\0\xff\0\0\0a\0',
            'these 10 bytes are not a std_msgs/msg/String: a count of 255 at byte 0 reaches beyond the end',
        ),
        (b'\0\1\0\0\2\0\0\0ab', 'these 10 bytes are not a std_msgs/msg/String: a string at byte 4 does not end with a zero'),
    ],
)
def test_other_bytes_are_an_interface_error(get, data, text):
    with pytest.raises(InterfaceError) as caught:
        cdr.deserialize(data, get('std_msgs/msg/String'))
    assert str(caught.value).startswith(text)


def test_what_follows_a_message_does_not_matter(get):
    """Fast DDS leaves up to some hundred bytes behind a message with sequences."""
    data = b'\0\1\0\0\3\0\0\0hi\0'
    for more in (b'', b'\0', b'\0' * 4, b'\1' * 400):
        assert cdr.deserialize(data + more, get('std_msgs/msg/String')).data == 'hi'

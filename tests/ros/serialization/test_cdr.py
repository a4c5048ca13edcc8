import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.errors import InterfaceError
from edulaunch.ros.serialization import cdr


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
                '  help: pass the bytes of a std_msgs/msg/String, which start with 00 01 00 00'
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


@pytest.mark.parametrize(
    ('text', 'wire', 'body'),
    [
        ('uint8 a\nfloat64 b', (1, 0.0), '01 00000000000000 0000000000000000'),
        ('string a\nuint16 b', ('hi', 1), '03000000 686900 00 0100'),
        ('uint8[] a\nuint32 b', (b'\1', 2), '01000000 01 000000 02000000'),
        ('float64[] a\nuint8 b', ((), 1), '00000000 01'),
        ('float64[] a', ((1.0,),), '01000000 00000000 000000000000f03f'),
        ('wstring a', ('h\U0001f422',), '03000000 68000000 3dd80000 22dc0000'),
        ('bool[2] a\nbyte[] b', ((True, False), b'xy'), '0100 0000 02000000 7879'),
        ('std_msgs/Empty a\nuint16 b', (1,), '00 00 0100'),
        ('', (), '00'),
    ],
)
def test_fields_are_aligned_to_their_size(define, text, wire, body):
    cls = define('T.msg', text)
    assert cdr.encode(cls, wire)[4:].hex() == body.replace(' ', '')
    assert cdr.decode(cls, cdr.encode(cls, wire)) == wire


TYPES = ['std_msgs/msg/String', 'sensor_msgs/msg/JointState', 'tf2_msgs/msg/TFMessage', 'rcl_interfaces/msg/ParameterEvent']


@given(st.binary(max_size=60), st.sampled_from(TYPES))
def test_arbitrary_bytes_are_a_message_or_an_interface_error(body, name):
    cls = underlay_registry().get(name)
    try:
        cdr.decode(cls, cdr.HEADER + body)
    except InterfaceError as problem:
        assert name in problem.message

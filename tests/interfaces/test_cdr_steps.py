import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.errors import InterfaceError
from edulaunch.interfaces import cdr
from edulaunch.interfaces.underlay import underlay_registry


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

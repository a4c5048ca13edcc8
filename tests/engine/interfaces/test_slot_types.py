from edulaunch.engine.interfaces.slot_types import (
    Array,
    BasicType,
    BoundedSequence,
    BoundedString,
    NamespacedType,
    UnboundedSequence,
    UnboundedString,
    UnboundedWString,
)


def test_slot_types_describe_each_field(define):
    cls = define('All.msg', 'float64 a\nstring b\nstring<=3[] c\nwstring d\nint8[2] e\nuint8[<=4] f\ngeometry_msgs/Point g')
    assert (
        BasicType('double'),
        UnboundedString(),
        UnboundedSequence(BoundedString(3)),
        UnboundedWString(),
        Array(BasicType('int8'), 2),
        BoundedSequence(BasicType('uint8'), 4),
        NamespacedType(('geometry_msgs', 'msg'), 'Point'),
    ) == cls.SLOT_TYPES

"""Messages of a student's own types, read from a recording without the workspace."""

from __future__ import annotations

from array import array
from typing import Any

import numpy
import pytest

from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.recording.recorded_types import RecordedTypes

TEXTS = {
    'my/msg/Leg': 'string name\nfloat64[] angles\n',
    'my/msg/Robot': (
        'uint8 LEGS=4\nint32 number\nmy/Leg front\nmy/Leg[] others\ngeometry_msgs/Point place\n'
        'float64[3] size\nuint8[2] pair\nbyte[] raw\nbool[] flags\nstring[] words\n'
    ),
}
WIRE = [
    7,
    'front',
    [1.0, 2.0],
    [['left', []], ['right', [0.5]]],
    1.0,
    2.0,
    3.0,
    [1.0, 2.0, 3.0],
    b'ab',
    b'cd',
    [True, False],
    ['x'],
]


@pytest.fixture
def types() -> RecordedTypes:
    return RecordedTypes(TEXTS, underlay_registry())


@pytest.fixture
def robot(types: RecordedTypes) -> Any:
    return types.get('my/msg/Robot').from_wire(WIRE)


def test_each_field_has_the_value_that_a_message_of_a_workspace_has(types: RecordedTypes, robot: Any) -> None:
    assert (robot.number, robot.LEGS, robot.flags, robot.words, robot.raw) == (7, 4, [True, False], ['x'], [b'c', b'd'])
    assert (robot.front.name, robot.front.angles, type(robot.front)) == ('front', array('d', [1.0, 2.0]), types.get('my/msg/Leg'))
    assert [(leg.name, leg.angles.tolist()) for leg in robot.others] == [('left', []), ('right', [0.5])]
    assert (robot.place.x, robot.place.y, robot.place.z) == (1.0, 2.0, 3.0)
    assert isinstance(robot.size, numpy.ndarray) and robot.size.tolist() == [1.0, 2.0, 3.0]
    assert robot.pair.tolist() == [97, 98]


def test_a_message_gives_back_its_wire_as_tuples_and_equals_one_with_the_same(types: RecordedTypes, robot: Any) -> None:
    again, other = (types.get('my/msg/Robot').from_wire([number, *WIRE[1:]]) for number in (7, 8))
    assert robot.to_wire()[:4] == (7, 'front', (1.0, 2.0), (('left', ()), ('right', (0.5,))))
    assert (robot == again, robot == other, robot == robot.to_wire()) == (True, False, False)
    with pytest.raises(TypeError, match='unhashable'):
        hash(robot)


def test_a_message_shows_its_fields_and_lists_its_wire(types: RecordedTypes, robot: Any) -> None:
    assert repr(robot.front) == "my.msg.Leg(name='front', angles=[1.0, 2.0])"
    assert types.get('my/msg/Leg').wire_type() == (('name', 'string'), ('angles', 'float64[]'))
    assert types.checks.check('my/msg/Robot')([WIRE]) and not types.checks.check('my/msg/Robot')([WIRE[1:]])


def test_types_that_everybody_has_are_the_usual_classes(types: RecordedTypes) -> None:
    assert types.get('geometry_msgs/msg/Point') is underlay_registry().get('geometry_msgs/msg/Point')

"""The values of messages are looked at field by field, for all messages together."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.recording.wire_check import WireChecks

FITTING: dict[str, list[Any]] = {
    'geometry_msgs/msg/Point': [[1.0, 2.0, 3.0], (4.0, 5.0, 6.0)],
    'std_msgs/msg/UInt8': [[0], [255]],
    'std_msgs/msg/Bool': [[True]],
    'geometry_msgs/msg/PoseWithCovariance': [[0.0] * 7 + [[0.0] * 36], [0.0] * 7 + [(1.0,) * 36]],
    'geometry_msgs/msg/Polygon': [[[]], [[[1.0, 2.0, 3.0], [1.0, 2.0, 3.0]]]],
}
ODD: list[tuple[str, Any]] = [
    ('geometry_msgs/msg/Point', [1.0, 2.0]),
    ('geometry_msgs/msg/Point', [1.0, 2.0, 3]),
    ('geometry_msgs/msg/Point', 'abc'),
    ('geometry_msgs/msg/Point', None),
    ('std_msgs/msg/UInt8', [256]),
    ('std_msgs/msg/UInt8', [-1]),
    ('std_msgs/msg/UInt8', [True]),
    ('std_msgs/msg/Bool', [1]),
    ('geometry_msgs/msg/PoseWithCovariance', [0.0] * 7 + [[0.0] * 35]),
    ('geometry_msgs/msg/PoseWithCovariance', [0.0] * 7 + [[0.0] * 35 + ['0']]),
    ('geometry_msgs/msg/Polygon', [[[1.0, 2.0, 3.0], [1.0, 2.0, None]]]),
    ('geometry_msgs/msg/Polygon', [{}]),
]


@pytest.mark.parametrize('name', FITTING)
def test_messages_that_fit(name: str) -> None:
    check = WireChecks(underlay_registry()).check(name)
    assert check(FITTING[name])
    assert check([])


@pytest.mark.parametrize(('name', 'odd'), ODD)
@pytest.mark.parametrize('place', [0, 1, 2])
def test_one_odd_message_among_others(name: str, odd: Any, place: int) -> None:
    wires = list(FITTING[name])
    wires.insert(min(place, len(wires)), odd)
    assert not WireChecks(underlay_registry()).check(name)(wires)

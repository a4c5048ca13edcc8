"""Hypothesis strategies and short constructors for the tests of edulaunch.engine.tf."""

from __future__ import annotations

import pytest
from hypothesis import strategies as st

from edulaunch.engine.tf import TransformBuffer, TransformFailure
from edulaunch.engine.tf.quaternions import canonical, from_euler
from edulaunch.engine.tf.transforms import Transform

SECOND = 1_000_000_000
numbers = st.floats(-100.0, 100.0)
angles = st.floats(-3.1, 3.1)
rotations = st.builds(from_euler, angles, st.floats(-1.5, 1.5), angles).map(canonical)
poses = st.builds(lambda x, y, z, q: (x, y, z, *q), numbers, numbers, numbers, rotations)


def at(x: float, y: float = 0.0, yaw: float = 0.0) -> Transform:
    """A pose in the plane."""
    return (x, y, 0.0, *from_euler(0.0, 0.0, yaw))


def chain_of(depth: int, samples: int = 1, period_ns: int = SECOND) -> TransformBuffer:
    """Frames f0 -> f1 -> ... -> f<depth>, each 1 m further along x."""
    buffer = TransformBuffer(cache_ns=samples * period_ns)
    for index in range(samples):
        for link in range(depth):
            buffer.set(f'f{link}', f'f{link + 1}', (index + 1) * period_ns, at(1.0, yaw=0.1))
    return buffer


def x_of(buffer: TransformBuffer, target: str, source: str, time_ns: int = 0) -> float:
    """The x of a lookup."""
    return buffer.lookup(target, source, time_ns)[1][0]


def failure_of(buffer: TransformBuffer, *arguments: object) -> tuple[str, str]:
    """Kind and text of the failure of a lookup."""
    with pytest.raises(TransformFailure) as caught:
        buffer.lookup(*arguments)
    return caught.value.kind, str(caught.value)

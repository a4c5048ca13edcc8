"""Rotations and vectors by chance, which repeat from run to run: the generator is seeded by the run's seed and the program."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin, sqrt
from random import Random
from typing import Any

from edulaunch.processes.current import current_process
from edulaunch.tf.quaternions import Quaternion
from tf_transformations.quaternions import quaternion_matrix


def random_quaternion(rand: Sequence[float] | None = None) -> Quaternion:
    """A rotation, all being equally likely.

    :param rand: three numbers from 0 to 1 that decide which.
    """
    first, second, third = (_generator().random() for _ in range(3)) if rand is None else rand
    inner, outer = sqrt(1.0 - first), sqrt(first)
    a, b = 2.0 * pi * second, 2.0 * pi * third
    return (sin(a) * inner, cos(a) * inner, sin(b) * outer, cos(b) * outer)


def random_rotation_matrix(rand: Sequence[float] | None = None) -> Any:
    """The 4x4 matrix of :func:`random_quaternion`."""
    return quaternion_matrix(random_quaternion(rand))


def random_vector(size: int) -> Any:
    """So many numbers from 0 to 1, as an array."""
    import numpy

    generator = _generator()
    return numpy.array([generator.random() for _ in range(size)])


def _generator() -> Random:
    process = current_process()
    generator: Random = process.state.setdefault('tf_transformations', process.sim.random(f'{process.name}/tf_transformations'))
    return generator

"""Rotations and homogeneous matrices under the names of the ROS package tf_transformations. Like that package, this module uses
transforms3d.

Quaternions are (x, y, z, w), as in ROS messages (in transforms3d, w is first). Angles are in radians, and matrices are 4x4 numpy
arrays. `axes` is 's' (fixed axes) or 'r' (turning axes) and three letters, such as 'sxyz'. It may also be four numbers: first
axis, odd order, repeated, turning. Impossible computations raise `ValueError`, and unknown axes raise `KeyError`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from random import Random
from typing import Any, TypeAlias

import numpy

# tf_transformations passes on these names, which are private in transforms3d.
from transforms3d import _gohlketransforms as _matrices
from transforms3d._gohlketransforms import (
    arcball_constrain_to_axis,
    arcball_map_to_sphere,
    arcball_nearest_axis,
    clip_matrix,
    compose_matrix,
    concatenate_matrices,
    euler_matrix,
    identity_matrix,
    inverse_matrix,
    orthogonalization_matrix,
    translation_matrix,
    unit_vector,
    vector_norm,
)

from edulaunch.engine.processes.current import current_process

__all__ = [
    'ROTATION_IDENTITY',
    'SHEAR_IDENTITY',
    'TRANSLATION_IDENTITY',
    'ZOOM_IDENTITY',
    'Arcball',
    'arcball_constrain_to_axis',
    'arcball_map_to_sphere',
    'arcball_nearest_axis',
    'clip_matrix',
    'compose_matrix',
    'concatenate_matrices',
    'decompose_matrix',
    'euler_from_matrix',
    'euler_from_quaternion',
    'euler_matrix',
    'identity_matrix',
    'inverse_matrix',
    'is_same_transform',
    'orthogonalization_matrix',
    'projection_from_matrix',
    'projection_matrix',
    'quaternion_about_axis',
    'quaternion_conjugate',
    'quaternion_from_euler',
    'quaternion_from_matrix',
    'quaternion_inverse',
    'quaternion_matrix',
    'quaternion_multiply',
    'quaternion_slerp',
    'random_quaternion',
    'random_rotation_matrix',
    'random_vector',
    'reflection_from_matrix',
    'reflection_matrix',
    'rotation_from_matrix',
    'rotation_matrix',
    'scale_from_matrix',
    'scale_matrix',
    'shear_from_matrix',
    'shear_matrix',
    'superimposition_matrix',
    'translation_from_matrix',
    'translation_matrix',
    'unit_vector',
    'vector_norm',
]

Quaternion: TypeAlias = tuple[float, float, float, float]
Axes: TypeAlias = 'str | tuple[int, int, int, int]'

TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ROTATION_IDENTITY = identity_matrix()[:3, :3]
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY


def _of_arrays(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that converts sequences among its arguments to arrays of floats, and then calls `function`.

    With other sequences, `function` would copy arrays under numpy 1, and raise an error under numpy 2.
    """

    @functools.wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        return function(*map(_as_array, args), **{name: _as_array(value) for name, value in options.items()})

    return call


def _as_array(value: Any) -> Any:
    return numpy.asarray(value, dtype=float) if isinstance(value, (list, tuple, numpy.ndarray)) else value


decompose_matrix = _of_arrays(_matrices.decompose_matrix)
is_same_transform = _of_arrays(_matrices.is_same_transform)
projection_from_matrix = _of_arrays(_matrices.projection_from_matrix)
projection_matrix = _of_arrays(_matrices.projection_matrix)
reflection_from_matrix = _of_arrays(_matrices.reflection_from_matrix)
reflection_matrix = _of_arrays(_matrices.reflection_matrix)
rotation_from_matrix = _of_arrays(_matrices.rotation_from_matrix)
rotation_matrix = _of_arrays(_matrices.rotation_matrix)
scale_from_matrix = _of_arrays(_matrices.scale_from_matrix)
scale_matrix = _of_arrays(_matrices.scale_matrix)
shear_from_matrix = _of_arrays(_matrices.shear_from_matrix)
shear_matrix = _of_arrays(_matrices.shear_matrix)
superimposition_matrix = _of_arrays(_matrices.superimposition_matrix)
translation_from_matrix = _of_arrays(_matrices.translation_from_matrix)


def euler_from_matrix(matrix: Any, axes: Axes = 'sxyz') -> tuple[float, float, float]:
    """Return the three angles of the rotation in a 4x4 or 3x3 matrix. By default, they are roll, pitch and yaw."""
    angles: tuple[float, float, float] = _matrices.euler_from_matrix(_as_array(matrix), axes)
    return angles


def euler_from_quaternion(quaternion: Sequence[float], axes: Axes = 'sxyz') -> tuple[float, float, float]:
    """Return the three angles of a rotation. By default, they are roll, pitch and yaw."""
    angles: tuple[float, float, float] = _matrices.euler_from_quaternion(_w_first(quaternion), axes)
    return angles


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = 'sxyz') -> Quaternion:
    """Return the quaternion of a rotation by three angles. By default, they are roll, pitch and yaw."""
    return _w_last(_matrices.quaternion_from_euler(ai, aj, ak, axes))


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> Quaternion:
    """Return the quaternion of a rotation by an angle about an axis of any length."""
    return _w_last(_matrices.quaternion_about_axis(angle, axis))


def quaternion_matrix(quaternion: Sequence[float]) -> Any:
    """Return the 4x4 homogeneous matrix of a rotation. For a zero quaternion, return the identity."""
    return _matrices.quaternion_matrix(_w_first(quaternion))


def quaternion_from_matrix(matrix: Any, isprecise: bool = False) -> Quaternion:
    """Return the quaternion of the rotation in a 4x4 or 3x3 matrix, with w >= 0.

    :param isprecise: whether to assume that the matrix is exactly a rotation, which is faster.
    """
    return _w_last(_matrices.quaternion_from_matrix(_as_array(matrix), isprecise))


def quaternion_multiply(quaternion1: Sequence[float], quaternion0: Sequence[float]) -> Quaternion:
    """Return the rotation by `quaternion0` followed by the rotation by `quaternion1`."""
    return _w_last(_matrices.quaternion_multiply(_w_first(quaternion1), _w_first(quaternion0)))


def quaternion_conjugate(quaternion: Sequence[float]) -> Quaternion:
    """Return the conjugate of a quaternion. For a unit quaternion, it is the opposite rotation."""
    return _w_last(_matrices.quaternion_conjugate(_w_first(quaternion)))


def quaternion_inverse(quaternion: Sequence[float]) -> Quaternion:
    """Return the inverse of a quaternion of any length. The product of a quaternion and its inverse is (0, 0, 0, 1)."""
    return _w_last(_matrices.quaternion_inverse(_w_first(quaternion)))


def quaternion_slerp(
    quat0: Sequence[float], quat1: Sequence[float], fraction: float, spin: int = 0, shortestpath: bool = True
) -> Quaternion:
    """Return the rotation at `fraction` (0 to 1) of the way from `quat0` to `quat1`.

    :param spin: the number of additional half turns on the way.
    :param shortestpath: whether to use the shorter of the two ways.
    """
    return _w_last(_matrices.quaternion_slerp(_w_first(quat0), _w_first(quat1), fraction, spin, shortestpath))


def random_quaternion(rand: Sequence[float] | None = None) -> Quaternion:
    """Return a random rotation. All rotations are equally likely.

    :param rand: three numbers from 0 to 1 that determine the rotation. None means random numbers, which are equal in every run
        with the same seed.
    """
    return _w_last(_matrices.random_quaternion(_by_chance(3) if rand is None else rand))


def random_rotation_matrix(rand: Sequence[float] | None = None) -> Any:
    """Return a random rotation as a 4x4 matrix; see :func:`random_quaternion`."""
    return _matrices.random_rotation_matrix(_by_chance(3) if rand is None else rand)


def random_vector(size: int) -> Any:
    """Return an array of `size` random numbers from 0 to 1. They are equal in every run with the same seed."""
    return _by_chance(size)


class Arcball(_matrices.Arcball):  # type: ignore[misc]
    """The rotation of a virtual ball that the user drags from one place of the screen to another.

    :param initial: the initial rotation: a quaternion (x, y, z, w) or a matrix.
    """

    def __init__(self, initial: Any = None) -> None:
        is_quaternion = initial is not None and len(initial) == 4 and not hasattr(initial[0], '__len__')
        super().__init__(_w_first(initial) if is_quaternion else initial)

    def setaxes(self, *axes: Sequence[float] | None) -> None:
        """Set the axes to which a rotation may be limited, or None for no axes."""
        present: list[Sequence[float] | None] = [axis for axis in axes if axis is not None]
        super().setaxes(*present or [None])

    def setconstrain(self, constrain: bool) -> None:
        """Set whether rotations are limited to the nearest of the axes."""
        self.constrain = bool(constrain)

    def getconstrain(self) -> bool:
        """Return whether rotations are limited to one axis."""
        return bool(self.constrain)


def _w_first(quaternion: Sequence[float]) -> Quaternion:
    x, y, z, w = quaternion
    return (w, x, y, z)


def _w_last(quaternion: Sequence[float]) -> Quaternion:
    w, x, y, z = (float(value) for value in quaternion)
    return (x, y, z, w)


def _by_chance(size: int) -> Any:
    """Return an array of `size` random numbers from 0 to 1."""
    process = current_process()
    generator: Random = process.state.setdefault('tf_transformations', process.sim.random(f'{process.name}/tf_transformations'))
    return numpy.array([generator.random() for _ in range(size)])

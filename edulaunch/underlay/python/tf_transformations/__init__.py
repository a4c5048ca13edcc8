"""Rotations and homogeneous matrices under the names of the ROS package tf_transformations.

Quaternions are tuples (x, y, z, w); angles are radians; matrices are 4x4 numpy arrays. numpy is loaded by the
functions that return arrays only. `axes` is 's' (fixed axes) or 'r' (turning axes) and three letters, such as
'sxyz'.
"""

from __future__ import annotations

from typing import Any

from tf_transformations.affine import (
    compose_matrix,
    decompose_matrix,
    is_same_transform,
    reflection_matrix,
    rotation_from_matrix,
    scale_matrix,
)
from tf_transformations.eulers import (
    euler_from_matrix,
    euler_from_quaternion,
    euler_matrix,
    quaternion_from_euler,
)
from tf_transformations.matrices import (
    concatenate_matrices,
    identity_matrix,
    inverse_matrix,
    rotation_matrix,
    translation_from_matrix,
    translation_matrix,
)
from tf_transformations.quaternions import (
    quaternion_about_axis,
    quaternion_conjugate,
    quaternion_from_matrix,
    quaternion_inverse,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
    unit_vector,
    vector_norm,
)

__all__ = [
    'compose_matrix',
    'concatenate_matrices',
    'decompose_matrix',
    'euler_from_matrix',
    'euler_from_quaternion',
    'euler_matrix',
    'identity_matrix',
    'inverse_matrix',
    'is_same_transform',
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
    'reflection_matrix',
    'rotation_from_matrix',
    'rotation_matrix',
    'scale_matrix',
    'translation_from_matrix',
    'translation_matrix',
    'unit_vector',
    'vector_norm',
]

_BY_CHANCE = ('random_quaternion', 'random_rotation_matrix', 'random_vector')


def __getattr__(name: str) -> Any:
    if name in _BY_CHANCE:
        from tf_transformations import chance

        return getattr(chance, name)
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')

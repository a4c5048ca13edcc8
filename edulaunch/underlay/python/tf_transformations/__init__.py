"""Rotations and homogeneous matrices under the names of the ROS package tf_transformations.

Quaternions are tuples (x, y, z, w); angles are radians; matrices are 4x4 numpy arrays. numpy is loaded by the
functions that return arrays only. `axes` is 's' (fixed axes) or 'r' (turning axes) and three letters, such as
'sxyz', or four numbers: first axis, odd order, repeated, turning.
"""

from __future__ import annotations

from typing import Any

from tf_transformations.affine import (
    compose_matrix,
    decompose_matrix,
    is_same_transform,
    reflection_from_matrix,
    reflection_matrix,
    rotation_from_matrix,
    scale_from_matrix,
    scale_matrix,
)
from tf_transformations.arcball import Arcball, arcball_constrain_to_axis, arcball_map_to_sphere, arcball_nearest_axis
from tf_transformations.eulers import euler_from_matrix, euler_from_quaternion, euler_matrix, quaternion_from_euler
from tf_transformations.matrices import (
    concatenate_matrices,
    identity_matrix,
    inverse_matrix,
    rotation_matrix,
    translation_from_matrix,
    translation_matrix,
)
from tf_transformations.projections import clip_matrix, projection_from_matrix, projection_matrix
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
from tf_transformations.shears import orthogonalization_matrix, shear_from_matrix, shear_matrix
from tf_transformations.superimposition import superimposition_matrix

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

TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY

_BY_CHANCE = ('random_quaternion', 'random_rotation_matrix', 'random_vector')


def __getattr__(name: str) -> Any:
    if name in _BY_CHANCE:
        from tf_transformations import chance

        return getattr(chance, name)
    if name == 'ROTATION_IDENTITY':
        return identity_matrix()[:3, :3]
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')

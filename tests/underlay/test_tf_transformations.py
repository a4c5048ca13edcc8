"""tf_transformations: the functions that students use."""

from __future__ import annotations

from itertools import product
from math import pi

import numpy as np
import pytest
import tf_transformations as under_test
from hypothesis import given
from hypothesis import strategies as st

AXES = [
    frame + ''.join(letters)
    for frame in 'sr'
    for letters in product('xyz', repeat=3)
    if letters[0] != letters[1] != letters[2]
]
angles = st.floats(-3.0, 3.0)


def test_yaw_is_the_third_angle_and_the_quaternion_ends_with_w():
    assert under_test.quaternion_from_euler(0, 0, pi / 2) == pytest.approx((0.0, 0.0, 0.5**0.5, 0.5**0.5))
    assert under_test.euler_from_quaternion([0.0, 0.0, 0.5**0.5, 0.5**0.5]) == pytest.approx(
        (0.0, 0.0, pi / 2)
    )


def test_there_are_24_sequences_of_axes_and_others_are_refused():
    assert len(AXES) == 24
    for axes in ('xyz', 'sxxy', 'rxyy', 'sabc'):
        with pytest.raises(KeyError):
            under_test.quaternion_from_euler(0, 0, 0, axes)


@given(angles, angles, angles, st.sampled_from(AXES))
def test_angles_read_from_a_matrix_make_the_same_matrix(a, b, c, axes):
    matrix = under_test.euler_matrix(a, b, c, axes)
    again = under_test.euler_matrix(*under_test.euler_from_matrix(matrix, axes), axes)
    assert np.allclose(again, matrix, atol=1e-6)


@pytest.mark.parametrize('axes', AXES)
@pytest.mark.parametrize('middle', [0.0, pi, pi / 2, -pi / 2])
def test_where_two_axes_coincide_the_matrix_is_still_right(axes, middle):
    matrix = under_test.euler_matrix(0.3, middle, 0.4, axes)
    assert np.allclose(
        under_test.euler_matrix(*under_test.euler_from_matrix(matrix, axes), axes), matrix, atol=1e-6
    )


def test_turning_axes_are_applied_in_the_other_order():
    fixed = under_test.quaternion_from_euler(0.1, 0.2, 0.3, 'sxyz')
    assert under_test.quaternion_from_euler(0.3, 0.2, 0.1, 'rzyx') == pytest.approx(fixed)


@given(angles, angles, angles)
def test_a_quaternion_and_its_matrix_are_the_same_rotation(a, b, c):
    q = under_test.quaternion_from_euler(a, b, c)
    found = under_test.quaternion_from_matrix(under_test.quaternion_matrix(q))
    assert abs(np.dot(found, q)) == pytest.approx(1.0)
    assert found[3] >= 0.0


@given(angles, angles)
def test_a_product_is_the_product_of_the_matrices(a, b):
    p, q = under_test.quaternion_from_euler(a, b, 0.3), under_test.quaternion_from_euler(b, 0.1, a)
    assert np.allclose(
        under_test.quaternion_matrix(under_test.quaternion_multiply(p, q)),
        under_test.quaternion_matrix(p) @ under_test.quaternion_matrix(q),
    )


def test_the_inverse_undoes_whatever_the_length():
    q = (0.0, 0.0, 2.0, 2.0)
    assert under_test.quaternion_multiply(under_test.quaternion_inverse(q), q) == pytest.approx(
        (0.0, 0.0, 0.0, 1.0)
    )
    assert under_test.quaternion_conjugate(q) == (0.0, 0.0, -2.0, 2.0)


def test_matrices_concatenate_from_right_to_left():
    moved = under_test.concatenate_matrices(
        under_test.translation_matrix((1, 2, 3)), under_test.rotation_matrix(pi / 2, (0, 0, 1))
    )
    assert np.allclose(moved @ (1, 0, 0, 1), (1, 3, 3, 1))
    assert np.allclose(under_test.translation_from_matrix(moved), (1, 2, 3))
    assert np.allclose(under_test.inverse_matrix(moved) @ moved, under_test.identity_matrix())


def test_a_turn_about_a_point_leaves_the_point_in_place():
    assert np.allclose(under_test.rotation_matrix(1.0, (0, 0, 2), (3, 4, 5)) @ (3, 4, 5, 1), (3, 4, 5, 1))


def test_about_an_axis_and_half_way():
    whole = under_test.quaternion_about_axis(pi / 2, (0, 0, 5))
    half = under_test.quaternion_slerp((0, 0, 0, 1), whole, 0.5)
    assert half == pytest.approx(under_test.quaternion_from_euler(0, 0, pi / 4))


def test_vectors_have_lengths():
    assert under_test.vector_norm((3.0, 4.0)) == 5.0
    assert np.allclose(under_test.unit_vector((3.0, 4.0)), (0.6, 0.8))


@given(st.tuples(*[st.floats(0.2, 3.0)] * 3), st.tuples(*[st.floats(-1.0, 1.0)] * 3), st.tuples(*[st.floats(-1.4, 1.4)] * 3))
def test_a_matrix_is_put_together_again_from_its_parts(scale, shear, turn):
    matrix = under_test.compose_matrix(scale, shear, turn, (1.0, 2.0, 3.0))
    parts = under_test.decompose_matrix(matrix)
    assert under_test.is_same_transform(under_test.compose_matrix(*parts), matrix)
    assert (tuple(parts[0]), parts[2]) == (pytest.approx(scale), pytest.approx(turn, abs=1e-6))


def test_what_cannot_be_undone_has_no_parts():
    with pytest.raises(ValueError, match='Matrix is singular'):
        under_test.decompose_matrix(np.diag([0.0, 1.0, 1.0, 1.0]))


@given(st.floats(0.1, 3.0), st.sampled_from([(0, 0, 1), (1, 2, 3)]), st.tuples(*[st.floats(-2.0, 2.0)] * 3))
def test_the_axis_of_a_turn_is_found(angle, axis, point):
    matrix = under_test.rotation_matrix(angle, axis, point)
    assert under_test.is_same_transform(under_test.rotation_matrix(*under_test.rotation_from_matrix(matrix)), matrix)


def test_scaling_and_mirroring_keep_the_origin():
    assert (under_test.scale_matrix(2.0, (1.0, 0.0, 0.0)) @ (1.0, 1.0, 0.0, 1.0)).tolist() == [1.0, 2.0, 0.0, 1.0]
    assert (under_test.reflection_matrix((1.0, 0.0, 0.0), (2.0, 0.0, 0.0)) @ (3.0, 5.0, 0.0, 1.0)).tolist() == [-1.0, 5.0, 0.0, 1.0]


def test_chance_repeats_from_program_to_program_of_one_name():
    assert under_test.vector_norm(under_test.random_quaternion()) == pytest.approx(1.0)
    assert under_test.random_quaternion((0.0, 0.25, 0.0)) == pytest.approx((1.0, 0.0, 0.0, 0.0))
    assert under_test.random_rotation_matrix((0.5, 0.1, 0.7)).shape == (4, 4)
    assert len(under_test.random_vector(5)) == 5 and max(under_test.random_vector(5)) < 1.0
    with pytest.raises(AttributeError):
        under_test.__getattr__('random_nothing')

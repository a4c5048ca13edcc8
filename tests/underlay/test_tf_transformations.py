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
    frame + ''.join(letters) for frame in 'sr' for letters in product('xyz', repeat=3) if letters[0] != letters[1] != letters[2]
]
angles = st.floats(-3.0, 3.0)


def test_yaw_is_the_third_angle_and_the_quaternion_ends_with_w():
    assert under_test.quaternion_from_euler(0, 0, pi / 2) == pytest.approx((0.0, 0.0, 0.5**0.5, 0.5**0.5))
    assert under_test.euler_from_quaternion([0.0, 0.0, 0.5**0.5, 0.5**0.5]) == pytest.approx((0.0, 0.0, pi / 2))


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
    assert np.allclose(under_test.euler_matrix(*under_test.euler_from_matrix(matrix, axes), axes), matrix, atol=1e-6)


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
    assert under_test.quaternion_multiply(under_test.quaternion_inverse(q), q) == pytest.approx((0.0, 0.0, 0.0, 1.0))
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
    assert (under_test.reflection_matrix((1.0, 0.0, 0.0), (2.0, 0.0, 0.0)) @ (3.0, 5.0, 0.0, 1.0)).tolist() == [
        -1.0,
        5.0,
        0.0,
        1.0,
    ]


def test_chance_repeats_from_program_to_program_of_one_name():
    assert under_test.vector_norm(under_test.random_quaternion()) == pytest.approx(1.0)
    assert under_test.random_quaternion((0.0, 0.25, 0.0)) == pytest.approx((1.0, 0.0, 0.0, 0.0))
    assert under_test.random_rotation_matrix((0.5, 0.1, 0.7)).shape == (4, 4)
    assert len(under_test.random_vector(5)) == 5 and max(under_test.random_vector(5)) < 1.0
    with pytest.raises(AttributeError):
        under_test.__getattr__('random_nothing')


coordinates = st.tuples(*[st.floats(-3.0, 3.0)] * 3)
directions = coordinates.filter(lambda values: sum(value * value for value in values) > 0.1)


@given(st.floats(-3.0, 3.0).filter(lambda factor: abs(factor - 1.0) > 0.01), coordinates, st.none() | directions)
def test_what_a_matrix_scales_is_found(factor, origin, direction):
    matrix = under_test.scale_matrix(factor, origin, direction)
    found = under_test.scale_from_matrix(matrix)
    assert found[0] == pytest.approx(factor) and (found[2] is None) == (direction is None)
    assert under_test.is_same_transform(under_test.scale_matrix(*found), matrix)


@given(coordinates, directions)
def test_the_mirror_is_found(point, normal):
    matrix = under_test.reflection_matrix(point, normal)
    place, found = under_test.reflection_from_matrix(matrix)
    assert np.dot(np.subtract(place[:3], point), under_test.unit_vector(normal)) == pytest.approx(0.0, abs=1e-6)
    assert under_test.is_same_transform(under_test.reflection_matrix(place, found), matrix)


@given(coordinates, directions, directions.filter(bool))
def test_a_projection_ends_in_the_plane_and_is_found(point, normal, direction):
    normal = under_test.unit_vector(normal)
    if abs(normal @ under_test.unit_vector(direction)) < 0.1:
        direction = normal
    matrix = under_test.projection_matrix(point, normal, direction)
    assert np.allclose((matrix @ (1.0, 2.0, 3.0, 1.0))[:3] @ normal, np.dot(point, normal))
    place, found, along, eye, pseudo = under_test.projection_from_matrix(matrix)
    assert (eye, pseudo) == (None, False)
    assert under_test.is_same_transform(under_test.projection_matrix(place, found, along), matrix)


@given(coordinates, directions, coordinates, st.booleans())
def test_the_eye_of_a_perspective_is_found_whatever_the_matrix_is_multiplied_with(point, normal, eye, pseudo):
    matrix = under_test.projection_matrix(point, normal, perspective=eye, pseudo=pseudo)
    _, found, along, seen, _ = under_test.projection_from_matrix(2.0 * matrix, pseudo)
    assert along is None and np.allclose(seen, eye, atol=1e-6)
    assert np.allclose(found, under_test.unit_vector(normal))


def test_points_lie_where_the_eye_sees_them_on_the_plane():
    seen = under_test.projection_matrix((0, 0, 1), (0, 0, 1), perspective=(0, 0, 3)) @ (1.0, 2.0, 2.0, 1.0)
    assert np.allclose(seen / seen[3], (2.0, 4.0, 1.0, 1.0))


@pytest.mark.parametrize('perspective', [False, True])
def test_a_clipped_volume_fills_the_cube(perspective):
    matrix = under_test.clip_matrix(-1.0, 3.0, 1.0, 2.0, 4.0, 8.0, perspective)
    for corner in product((0, 1), repeat=3):
        depth = (4.0, 8.0)[corner[2]]
        wider = depth / 4.0 if perspective else 1.0
        seen = matrix @ ((-1.0, 3.0)[corner[0]] * wider, (1.0, 2.0)[corner[1]] * wider, depth, 1.0)
        assert np.allclose(seen[:3] / seen[3], [2 * side - 1 for side in corner])


def test_no_volume_is_no_frustum():
    with pytest.raises(ValueError, match='^invalid frustum$'):
        under_test.clip_matrix(1.0, 1.0, 0.0, 1.0, 0.0, 1.0)
    with pytest.raises(ValueError, match='invalid frustum: near <= 0'):
        under_test.clip_matrix(0.0, 1.0, 0.0, 1.0, 0.0, 1.0, perspective=True)


@given(st.floats(0.05, 1.4) | st.floats(-1.4, -0.05), directions, coordinates, directions)
def test_a_shear_keeps_its_plane_and_is_found(angle, direction, point, normal):
    direction = np.cross(direction, normal)
    if np.linalg.norm(direction) < 0.1:
        direction = np.cross(normal, (normal[1], -normal[2], normal[0] + 1.0))
    matrix = under_test.shear_matrix(angle, direction, point, normal)
    assert np.allclose(matrix @ (*point, 1.0), (*point, 1.0))
    assert under_test.shear_from_matrix(matrix)[0] == pytest.approx(abs(angle))
    assert under_test.is_same_transform(under_test.shear_matrix(*under_test.shear_from_matrix(matrix)), matrix)


@pytest.mark.parametrize(
    'function, words',
    [
        ('reflection_from_matrix', 'no unit eigenvector corresponding to eigenvalue -1'),
        ('scale_from_matrix', 'no eigenvector corresponding to eigenvalue 1'),
        ('projection_from_matrix', 'no eigenvector corresponding to eigenvalue 0'),
        ('shear_from_matrix', 'no two linear independent eigenvectors found'),
    ],
)
def test_a_turn_is_nothing_else(function, words):
    with pytest.raises(ValueError, match=words):
        getattr(under_test, function)(under_test.rotation_matrix(1.0, (0, 0, 1)))


def test_a_slide_out_of_its_plane_is_no_shear():
    with pytest.raises(ValueError, match='direction and normal vectors are not orthogonal'):
        under_test.shear_matrix(0.5, (1, 0, 0), (0, 0, 0), (1, 1, 0))


def test_the_edges_of_a_cell_have_its_lengths_and_angles():
    edges = under_test.orthogonalization_matrix((10.0, 20.0, 30.0), (80.0, 95.0, 110.0))[:3, :3].T
    assert [under_test.vector_norm(edge) for edge in edges] == pytest.approx([10.0, 20.0, 30.0])
    units = [under_test.unit_vector(edge) for edge in edges]
    between = [np.degrees(np.arccos(units[i] @ units[j])) for i, j in ((1, 2), (0, 2), (0, 1))]
    assert between == pytest.approx([80.0, 95.0, 110.0])


@pytest.mark.parametrize('usesvd', [True, False])
@pytest.mark.parametrize('scaling', [True, False])
def test_one_cloud_is_brought_onto_another(usesvd, scaling):
    moved = under_test.translation_matrix((1, 2, 3)) @ under_test.rotation_matrix(2.0, (1, 2, -1))
    if scaling:
        moved = moved @ under_test.scale_matrix(2.5)
    cloud = np.vstack([np.random.default_rng(1).normal(size=(3, 9)), np.ones(9)])
    assert np.allclose(under_test.superimposition_matrix(cloud, moved @ cloud, scaling, usesvd), moved)
    with pytest.raises(ValueError, match='input arrays are of wrong shape or type'):
        under_test.superimposition_matrix(cloud, cloud[:, :5])


def test_a_mirror_image_is_matched_by_a_turn():
    cloud = np.random.default_rng(1).normal(size=(3, 9))
    turns = [under_test.superimposition_matrix(cloud, -cloud, usesvd=usesvd) for usesvd in (True, False)]
    assert np.linalg.det(turns[0]) == pytest.approx(1.0) and np.allclose(*turns)


def test_the_ball_follows_the_pointer():
    ball = under_test.Arcball()
    ball.place((100, 100), 100)
    ball.down((100, 100))
    ball.drag((150, 100))
    assert np.allclose(ball.matrix() @ (0, 0, 1, 1), (np.sin(pi / 3), 0, np.cos(pi / 3), 1))
    ball.next()
    assert np.allclose(ball.matrix(), under_test.rotation_matrix(2 * pi / 3, (0, 1, 0)))


def test_a_constrained_ball_turns_about_the_nearest_axis():
    ball = under_test.Arcball(under_test.identity_matrix())
    ball.place((0, 0), 1)
    ball.setaxes((1, 0, 0), (0, 1, 0), None)
    ball.setconstrain(True)
    ball.down((0.5, 0.1))
    ball.drag((0.7, 0.3))
    assert ball.getconstrain() and np.allclose(ball.matrix() @ (0, 1, 0, 1), (0, 1, 0, 1))
    assert not np.allclose(ball.matrix(), np.identity(4))


def test_the_long_way_round_and_more_turns():
    start, end = (0, 0, 0, 1), tuple(-value for value in under_test.quaternion_about_axis(1.0, (0, 0, 1)))
    assert under_test.quaternion_slerp(start, end, 0.5) == pytest.approx(under_test.quaternion_about_axis(0.5, (0, 0, 1)))
    long = under_test.quaternion_slerp(start, end, 0.5, shortestpath=False)
    assert long == pytest.approx(under_test.quaternion_about_axis(0.5 - pi, (0, 0, 1)))
    assert under_test.quaternion_slerp(start, end, 0.5, spin=2)[2:] == pytest.approx((-np.sin(0.25), -np.cos(0.25)))


def test_axes_may_be_told_by_four_numbers():
    numbers = {'sxyz': (0, 0, 0, 0), 'syzx': (1, 0, 0, 0), 'sxzx': (0, 1, 1, 0), 'rzyx': (0, 0, 0, 1), 'rxyz': (2, 1, 0, 1)}
    for axes, four in numbers.items():
        assert under_test.quaternion_from_euler(0.1, 0.2, 0.3, four) == under_test.quaternion_from_euler(0.1, 0.2, 0.3, axes)
    with pytest.raises(KeyError):
        under_test.euler_matrix(0, 0, 0, (3, 0, 0, 0))


def test_lengths_along_an_axis_and_into_an_array():
    rows = np.array([[3.0, 4.0], [0.0, 2.0]])
    lengths = np.empty(2)
    assert under_test.vector_norm(rows, axis=1, out=lengths) is None and lengths.tolist() == [5.0, 2.0]
    assert under_test.unit_vector(rows, axis=1).tolist() == [[0.6, 0.8], [0.0, 1.0]]
    assert under_test.unit_vector(rows, axis=1, out=rows) is None and rows.tolist() == [[0.6, 0.8], [0.0, 1.0]]
    assert under_test.ROTATION_IDENTITY.tolist() == np.identity(3).tolist()

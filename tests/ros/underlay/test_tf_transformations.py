"""tf_transformations: what it adds to transforms3d, and that each of its names does its work with ROS's order of a quaternion."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
import tf_transformations as under_test


def test_yaw_is_the_third_angle_and_the_quaternion_ends_with_w():
    assert under_test.quaternion_from_euler(0, 0, pi / 2) == pytest.approx((0.0, 0.0, 0.5**0.5, 0.5**0.5))
    assert under_test.euler_from_quaternion([0.0, 0.0, 0.5**0.5, 0.5**0.5]) == pytest.approx((0.0, 0.0, pi / 2))


def test_turning_axes_are_applied_in_the_other_order():
    fixed = under_test.quaternion_from_euler(0.1, 0.2, 0.3, 'sxyz')
    assert under_test.quaternion_from_euler(0.3, 0.2, 0.1, 'rzyx') == pytest.approx(fixed)


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


def test_what_cannot_be_undone_has_no_parts():
    with pytest.raises(ValueError, match='matrix is singular'):
        under_test.decompose_matrix(np.diag([0.0, 1.0, 1.0, 1.0]))


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


def test_points_lie_where_the_eye_sees_them_on_the_plane():
    seen = under_test.projection_matrix((0, 0, 1), (0, 0, 1), perspective=(0, 0, 3)) @ (1.0, 2.0, 2.0, 1.0)
    assert np.allclose(seen / seen[3], (2.0, 4.0, 1.0, 1.0))


def test_no_volume_is_no_frustum():
    with pytest.raises(ValueError, match='^invalid frustum$'):
        under_test.clip_matrix(1.0, 1.0, 0.0, 1.0, 0.0, 1.0)
    with pytest.raises(ValueError, match='invalid frustum: near <= 0'):
        under_test.clip_matrix(0.0, 1.0, 0.0, 1.0, 0.0, 1.0, perspective=True)


def test_a_slide_out_of_its_plane_is_no_shear():
    with pytest.raises(ValueError, match='direction and normal vectors are not orthogonal'):
        under_test.shear_matrix(0.5, (1, 0, 0), (0, 0, 0), (1, 1, 0))


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


@pytest.mark.parametrize('axes', ['xyz', 'sxxy', 'rxyy', 'sabc'])
def test_unknown_axes_are_refused(axes):
    with pytest.raises(KeyError):
        under_test.quaternion_from_euler(0, 0, 0, axes)


@pytest.mark.parametrize('axes', ['sxyz', 'rzyx', 'sxzx', 'ryxz'])
@pytest.mark.parametrize('angles', [(0.1, 0.2, 0.3), (-2.0, 1.0, 3.0)])
def test_angles_quaternions_and_matrices_are_one_rotation(axes, angles):
    quaternion = under_test.quaternion_from_euler(*angles, axes)
    matrix = under_test.euler_matrix(*angles, axes)
    assert np.allclose(under_test.quaternion_matrix(quaternion), matrix)
    found = under_test.quaternion_from_matrix(matrix.tolist())
    assert abs(np.dot(found, quaternion)) == pytest.approx(1.0) and found[3] >= 0.0
    for read in (under_test.euler_from_matrix(matrix.tolist(), axes), under_test.euler_from_quaternion(quaternion, axes)):
        assert np.allclose(under_test.euler_matrix(*read, axes), matrix)


def test_a_product_turns_first_by_its_second_factor():
    first, then = under_test.quaternion_from_euler(0.1, 0.2, 0.3), under_test.quaternion_from_euler(-1.0, 0.5, 2.0)
    product = under_test.quaternion_matrix(under_test.quaternion_multiply(then, first))
    assert np.allclose(product, under_test.quaternion_matrix(then) @ under_test.quaternion_matrix(first))


POINT, NORMAL, ACROSS = [1, 2, 3], (0, 0, 2), (1, 0, 0)


@pytest.mark.parametrize(
    ('make', 'given', 'read'),
    [
        ('rotation_matrix', (0.5, NORMAL, POINT), 'rotation_from_matrix'),
        ('scale_matrix', (2.0, POINT), 'scale_from_matrix'),
        ('scale_matrix', (2.0, POINT, NORMAL), 'scale_from_matrix'),
        ('reflection_matrix', (POINT, NORMAL), 'reflection_from_matrix'),
        ('projection_matrix', (POINT, NORMAL), 'projection_from_matrix'),
        ('projection_matrix', (POINT, NORMAL, None, [5, 5, 9]), 'projection_from_matrix'),
        ('shear_matrix', (0.5, ACROSS, [0, 0, 0], NORMAL), 'shear_from_matrix'),
        ('compose_matrix', ((1, 2, 3), (0.1, 0.2, 0.3), (0.4, 0.5, 0.6), POINT), 'decompose_matrix'),
    ],
)
def test_what_a_matrix_is_made_of_is_found_again(make, given, read):
    matrix = getattr(under_test, make)(*given)
    parts = getattr(under_test, read)(matrix.tolist())
    assert under_test.is_same_transform(getattr(under_test, make)(*parts), matrix.tolist())


def test_a_clipped_volume_fills_the_cube_and_a_cell_has_its_edges():
    assert np.allclose(under_test.clip_matrix(-1, 3, 1, 2, 4, 8) @ (3, 2, 8, 1), (1, 1, 1, 1))
    edges = under_test.orthogonalization_matrix((10.0, 20.0, 30.0), (80.0, 95.0, 110.0))[:3, :3].T
    assert [under_test.vector_norm(edge) for edge in edges] == pytest.approx([10.0, 20.0, 30.0])

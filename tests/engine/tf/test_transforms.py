"""Rigid transforms as tuples."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf.transforms import IDENTITY, apply, canonical, compose, product, relative

from .shapes import at, numbers, poses


@given(poses)
def test_a_transform_and_its_inverse_cancel(pose):
    assert compose(pose, relative(pose, IDENTITY)) == pytest.approx(IDENTITY, abs=1e-9)


@given(poses, poses, numbers, numbers, numbers)
def test_a_composition_applies_the_right_transform_first(a, b, x, y, z):
    assert apply(compose(a, b), (x, y, z)) == pytest.approx(apply(a, apply(b, (x, y, z))), abs=1e-8)


@given(poses, poses)
def test_relative_is_the_inverse_of_one_composed_with_the_other(a, b):
    assert relative(a, b) == pytest.approx(compose(relative(a, IDENTITY), b), abs=1e-9)


@given(st.lists(st.one_of(poses, st.just(IDENTITY)), min_size=1, max_size=6))
def test_the_product_is_that_of_the_links_one_by_one(chain):
    expected = chain[0]
    for pose in chain[1:]:
        expected = compose(pose, expected)
    found = product(chain)
    assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) <= 1e-9 * max(1.0, *map(abs, expected))


def test_a_canonical_transform_has_no_negative_zeros():
    assert str(canonical((-0.0, 1.0, -0.0, -0.0, -0.0, -0.0, -1.0))) == '(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)'


def test_a_point_ahead_of_a_turned_frame():
    assert apply(at(1.0, 2.0, yaw=1.5707963267948966), (3.0, 0.0, 0.0)) == pytest.approx((1.0, 5.0, 0.0))

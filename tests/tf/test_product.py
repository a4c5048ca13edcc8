"""The product along a chain: the short way for flat frames gives what the long way gives, bit for bit."""

from __future__ import annotations

from math import cos, sin

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.tf.product import _product_on, product
from edulaunch.tf.transforms import IDENTITY, compose

from .shapes import poses

metres = st.floats(-1e6, 1e6)
flat_poses = st.builds(
    lambda x, y, z, yaw: (x, y, z, 0.0, 0.0, sin(yaw / 2), cos(yaw / 2)), metres, metres, metres, st.floats(-7, 7))
chains = st.lists(st.one_of(flat_poses, poses, st.just(IDENTITY)), min_size=1, max_size=6)


@given(st.lists(flat_poses, min_size=1, max_size=8))
def test_flat_frames_give_the_same_numbers_as_any_others(chain):
    assert product(chain) == _product_on(chain[0], chain[1:])


@given(chains)
def test_the_product_is_that_of_the_links_one_by_one(chain):
    expected = chain[0]
    for pose in chain[1:]:
        expected = compose(pose, expected)
    found = product(chain)
    assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) <= 1e-9 * max(1.0, *map(abs, expected))

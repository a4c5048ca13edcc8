"""The product along a chain: the short way for flat frames gives what the long way gives, bit for bit."""

from __future__ import annotations

from math import cos, sin
from struct import pack

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.tf.product import _product_on, product
from edulaunch.tf.transforms import IDENTITY, compose

from .shapes import poses

metres = st.one_of(st.floats(-1e6, 1e6), st.floats(allow_nan=False))
flat_poses = st.builds(
    lambda x, y, z, yaw: (x, y, z, 0.0, 0.0, sin(yaw / 2), cos(yaw / 2)), metres, metres, metres, st.floats(-7, 7)
)


def bits(value: float) -> bytes:
    """A number, told apart from its negative zero; what is shown of a transform has none (see `Path.at`), nor signs of nan."""
    return b'nan' if value != value else pack('d', value + 0.0)


chains = st.lists(st.one_of(poses, st.just(IDENTITY)), min_size=1, max_size=6)


@given(st.lists(flat_poses, min_size=1, max_size=8))
def test_flat_frames_give_the_same_numbers_as_any_others(chain):
    found, expected = (product(chain), _product_on(chain[0], chain[1:]))
    assert [bits(value) for value in found] == [bits(value) for value in expected]


@given(chains)
def test_the_product_is_that_of_the_links_one_by_one(chain):
    expected = chain[0]
    for pose in chain[1:]:
        expected = compose(pose, expected)
    found = product(chain)
    assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) <= 1e-9 * max(1.0, *map(abs, expected))

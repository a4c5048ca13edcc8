"""The remembered path: right products, forgotten in time, cheap in long histories."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf import TransformBuffer
from edulaunch.engine.tf.path import find_path
from edulaunch.engine.tf.transforms import IDENTITY, canonical, compose, product, relative

from .shapes import SECOND, at, chain_of, poses, x_of


@given(st.lists(poses, min_size=1, max_size=6))
def test_a_lookup_along_a_chain_is_the_product_of_its_links(links):
    buffer, product = TransformBuffer(), IDENTITY
    for index, link in enumerate(links):
        buffer.set(f'f{index}', f'f{index + 1}', SECOND, link)
        product = compose(product, link)
    found = buffer.lookup('f0', f'f{len(links)}')[1]
    assert found[:3] == pytest.approx(product[:3], abs=1e-7)
    assert abs(sum(p * q for p, q in zip(found[3:], product[3:], strict=True))) == pytest.approx(1.0)


@given(poses, poses)
def test_the_opposite_lookup_is_the_inverse(left, right):
    buffer = TransformBuffer()
    buffer.set('world', 'left', SECOND, left)
    buffer.set('world', 'right', SECOND, right)
    one, other = buffer.lookup('left', 'right')[1], buffer.lookup('right', 'left')[1]
    assert compose(one, other)[:3] == pytest.approx((0.0, 0.0, 0.0), abs=1e-7)
    assert relative(one, IDENTITY)[:3] == pytest.approx(other[:3], abs=1e-7)


def test_the_remembered_path_is_forgotten_when_a_frame_moves_to_another_parent():
    buffer = chain_of(3)
    buffer.set('f0', 'g', SECOND, at(5.0))
    before = x_of(buffer, 'f0', 'f3')
    buffer.set('g', 'f3', 2 * SECOND, at(1.0))
    buffer.set('f0', 'g', 2 * SECOND, at(5.0))
    assert (x_of(buffer, 'f0', 'f3'), x_of(buffer, 'f0', 'f3', SECOND)) == (6.0, pytest.approx(before))


def counted_steps(samples: int) -> int:
    """How many entries a lookup in the middle of a history looks at."""

    class Counting(list):
        looks = 0

        def __getitem__(self, index):
            Counting.looks += 1
            return super().__getitem__(index)

    buffer = chain_of(1, samples=samples)
    history = buffer._frames['f1']
    history.stamps = Counting(history.stamps)
    buffer.lookup('f0', 'f1', samples * SECOND // 2 + 1)
    return Counting.looks


def test_looking_far_back_costs_the_logarithm_of_the_history():
    assert 6 < counted_steps(256) < counted_steps(4096) < counted_steps(256) + 6


@given(st.lists(poses, min_size=1, max_size=5))
def test_what_is_shown_is_what_canonical_makes_of_the_product(links):
    buffer = TransformBuffer()
    for index, link in enumerate(links):
        buffer.set(f'f{index}', f'f{index + 1}', SECOND, link)
    stored = [buffer._frames[f'f{index + 1}'].poses[-1] for index in range(len(links))]
    assert buffer.lookup('f0', f'f{len(links)}')[1] == canonical(product(stored[::-1]))


def test_a_path_covers_the_times_that_all_its_frames_have_poses_of():
    buffer = TransformBuffer()
    for second in (1, 2, 3, 4):
        buffer.set('w', 'a', second * SECOND, at(1.0))
    for second in (2, 3):
        buffer.set('a', 'b', second * SECOND, at(1.0))
    buffer.set('b', 'c', 0, at(1.0), static=True)
    path = find_path(buffer._frames, 'w', 'c')
    assert [path.covers(time_ns) for time_ns in (0, 2 * SECOND - 1, 2 * SECOND, 3 * SECOND, 3 * SECOND + 1)] == [
        True,
        False,
        True,
        True,
        False,
    ]
    assert path.latest_common_time() == 3 * SECOND and path.at(0)[0] == 3 * SECOND and path.at(4 * SECOND) is None

"""The buffer against facts_tf2.md: inserts, lookups, latest common time, reparenting, full lookups."""

from __future__ import annotations

from math import nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.tf import TransformBuffer, TransformFailure
from edulaunch.tf.transforms import IDENTITY, compose, inverse

from .shapes import SECOND, at, chain_of, poses


def x_of(buffer: TransformBuffer, target: str, source: str, time_ns: int = 0) -> float:
    return buffer.lookup(target, source, time_ns)[1][0]


def failure_of(buffer: TransformBuffer, *arguments: object) -> tuple[str, str]:
    with pytest.raises(TransformFailure) as caught:
        buffer.lookup(*arguments)
    return caught.value.kind, str(caught.value)


@given(st.lists(poses, min_size=1, max_size=6))
def test_a_lookup_along_a_chain_is_the_product_of_its_links(links):
    buffer, product = TransformBuffer(), IDENTITY
    for index, link in enumerate(links):
        buffer.set(f'f{index}', f'f{index + 1}', SECOND, link)
        product = compose(product, link)
    found = buffer.lookup('f0', f'f{len(links)}')[1]
    assert found[:3] == pytest.approx(product[:3], abs=1e-7)
    assert abs(sum(p * q for p, q in zip(found[3:], product[3:]))) == pytest.approx(1.0)


@given(poses, poses)
def test_the_opposite_lookup_is_the_inverse(left, right):
    buffer = TransformBuffer()
    buffer.set('world', 'left', SECOND, left)
    buffer.set('world', 'right', SECOND, right)
    one, other = buffer.lookup('left', 'right')[1], buffer.lookup('right', 'left')[1]
    assert compose(one, other)[:3] == pytest.approx((0.0, 0.0, 0.0), abs=1e-7)
    assert inverse(one)[:3] == pytest.approx(other[:3], abs=1e-7)


def test_one_leading_slash_is_taken_off_when_inserting_and_refused_when_looking_up():
    buffer = TransformBuffer()
    assert buffer.set('/w', '/a', SECOND, at(1.0)) == ()
    assert buffer.frame_names() == ['a', 'w']
    assert x_of(buffer, 'w', 'a') == 1.0
    assert failure_of(buffer, '/w', 'a') == (
        'invalid_argument',
        (
            'Invalid argument "/w" passed to lookupTransform argument target_frame - '
            "in tf2 frame_ids cannot start with a '/'"
        ),
    )


def test_a_quaternion_of_another_length_is_normalised_silently():
    buffer = TransformBuffer()
    assert buffer.set('w', 'a', SECOND, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5)) == ()
    assert buffer.lookup('w', 'a')[1] == IDENTITY


def test_a_zero_quaternion_is_refused_twice_over():
    texts = [text for _, text in TransformBuffer().set('w', 'a', SECOND, (0.0,) * 7, 'me')]
    assert texts == [
        'TF_NAN_INPUT: Ignoring transform for child_frame_id "a" from authority "me" because of a nan value in the '
        'transform (0.000000 0.000000 0.000000) (-nan -nan -nan -nan)',
        'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "a" from authority "me" because of an '
        'invalid quaternion in the transform (-nan -nan -nan -nan)',
    ]


def test_a_known_frame_is_checked_as_well_as_a_new_one():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    ((severity, text),) = buffer.set('w', 'a', 2 * SECOND, (nan, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    assert (severity, text) == (
        'error',
        (
            'TF_NAN_INPUT: Ignoring transform for child_frame_id "a" from authority "default_authority" because of a nan '
            'value in the transform (nan 2.000000 0.000000) (0.000000 0.000000 0.000000 1.000000)'
        ),
    )
    assert buffer.lookup('w', 'a')[0] == SECOND


@pytest.mark.parametrize(
    ('parent', 'child', 'texts'),
    [
        (
            'a',
            'a',
            [
                'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "a" '
                'because they are the same'
            ],
        ),
        (
            'w',
            '',
            ['TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because child_frame_id not set '],
        ),
        (
            '',
            'a',
            [
                'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "a"  from authority "me" because frame_id '
                'not set'
            ],
        ),
    ],
)
def test_bad_frame_names_are_refused(parent, child, texts):
    buffer = TransformBuffer()
    assert [text for _, text in buffer.set(parent, child, SECOND, at(1.0), 'me')] == texts
    assert buffer.frame_names() == []


def test_data_older_than_the_cache_is_refused():
    buffer = TransformBuffer()
    buffer.set('w', 'a', 1_700_000_020 * SECOND, at(1.0))
    assert buffer.set('w', 'a', 1_700_000_010 * SECOND, at(2.0)) == ()
    assert buffer.set('w', 'a', 1_700_000_005 * SECOND, at(3.0)) == (
        (
            'warn',
            (
                'TF_OLD_DATA ignoring data from the past for frame a at time 1700000005.000000 according to authority '
                'default_authority\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained'
            ),
        ),
    )


def test_history_spans_the_cache_and_one_period():
    buffer = TransformBuffer()
    for second in range(1, 31):
        buffer.set('w', 'a', second * SECOND, at(float(second)))
    assert x_of(buffer, 'w', 'a', 19 * SECOND) == 19.0
    assert failure_of(buffer, 'w', 'a', 18 * SECOND)[1].startswith(
        'Lookup would require extrapolation into the past.  Requested time 18.000000 but the earliest data is at time '
        '19.000000'
    )


def test_late_samples_inside_the_window_are_welcome():
    buffer = TransformBuffer()
    for second in (10, 14, 12):
        buffer.set('w', 'a', second * SECOND, at(float(second) ** 2))
    assert x_of(buffer, 'w', 'a', 13 * SECOND) == (144.0 + 196.0) / 2


def test_another_kind_of_insert_drops_the_history():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.set('w', 'a', 0, at(2.0), static=True)
    assert buffer.lookup('w', 'a', 77)[1] == at(2.0)
    buffer.set('w', 'a', 5 * SECOND, at(3.0))
    assert failure_of(buffer, 'w', 'a', SECOND)[1].startswith(
        'Lookup would require extrapolation at time 1.000000, but only time 5.000000 is in the buffer'
    )


def test_a_static_transform_is_replaced_and_needs_no_stamp():
    buffer = TransformBuffer()
    buffer.set('w', 'a', 5, at(1.0), static=True)
    assert buffer.lookup('w', 'a') == (0, at(1.0))
    buffer.set('w', 'a', 5, at(2.0), static=True)
    assert buffer.lookup('w', 'a', 10**18) == (10**18, at(2.0))


def test_equal_names_give_the_identity_before_any_check():
    buffer = TransformBuffer()
    buffer.set('w', 'a', 3 * SECOND, at(1.0))
    for name in ('', '/x', 'unknown'):
        assert buffer.lookup(name, name, 7) == (7, IDENTITY)
    assert buffer.lookup('a', 'a') == (3 * SECOND, IDENTITY)
    assert buffer.lookup('w', 'w') == (0, IDENTITY)


def test_names_are_checked_target_first():
    buffer = TransformBuffer()
    assert failure_of(buffer, 'a', 'b') == (
        'lookup',
        '"a" passed to lookupTransform argument target_frame does not exist. ',
    )
    buffer.set('w', 'a', SECOND, at(1.0))
    assert failure_of(buffer, 'a', '') == (
        'invalid_argument',
        'Invalid argument "" passed to lookupTransform argument source_frame - '
        'in tf2 frame_ids cannot be empty',
    )


def test_the_latest_time_is_the_oldest_of_the_newest_stamps():
    buffer = TransformBuffer()
    for second in (1, 2, 3):
        buffer.set('w', 'a', second * SECOND, at(float(second)))
    for second in (1, 2):
        buffer.set('w', 'b', second * SECOND, at(0.0))
    buffer.set('b', 'c', 0, at(0.0), static=True)
    assert buffer.lookup('c', 'a') == (2 * SECOND, at(2.0))
    assert buffer.latest_common_time('c', 'a') == 2 * SECOND


def test_the_latest_lookup_can_still_miss_a_branch():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.set('w', 'b', 2 * SECOND, at(1.0))
    assert failure_of(buffer, 'a', 'b') == (
        'extrapolation',
        (
            'Lookup would require extrapolation at time 1.000000, but only time 2.000000 is in the buffer, '
            'when looking up transform from frame [b] to frame [a]'
        ),
    )


def test_frames_of_two_trees_are_not_connected():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.set('v', 'b', SECOND, at(1.0))
    for time_ns in (0, SECOND):
        assert failure_of(buffer, 'a', 'b', time_ns) == (
            'connectivity',
            (
                "Could not find a connection between 'a' and 'b' because they are not part of the same tree.Tf has two or "
                'more unconnected trees.'
            ),
        )


def test_the_future_is_not_invented():
    buffer = TransformBuffer()
    for second in (1, 2):
        buffer.set('world', 'turtle1', second * SECOND, at(1.0))
    assert failure_of(buffer, 'world', 'turtle1', 2 * SECOND + 1)[1] == (
        'Lookup would require extrapolation into the future.  Requested time 2.000000 but the latest data is at time '
        '2.000000, when looking up transform from frame [turtle1] to frame [world]'
    )


def test_a_new_parent_takes_over_at_once_and_old_times_keep_the_old_one():
    buffer = TransformBuffer()
    buffer.set('map', 'odom', 0, at(100.0), static=True)
    for second in (1, 2):
        buffer.set('map', 'base', second * SECOND, at(float(second)))
    for second in (3, 4):
        buffer.set('odom', 'base', second * SECOND, at(float(second)))
    assert [x_of(buffer, 'map', 'base', time) for time in (SECOND, int(2.5 * SECOND), 4 * SECOND, 0)] == [
        1.0,
        2.0,
        104.0,
        104.0,
    ]


def test_a_parent_of_another_tree_leaves_the_old_one_unconnected():
    buffer = TransformBuffer()
    buffer.set('map', 'base', SECOND, at(1.0))
    assert x_of(buffer, 'map', 'base') == 1.0
    buffer.set('odom', 'base', 2 * SECOND, at(2.0))
    assert failure_of(buffer, 'map', 'base')[0] == 'connectivity'
    assert x_of(buffer, 'map', 'base', SECOND) == 1.0


def test_a_failure_above_the_common_ancestor_does_not_matter():
    buffer = TransformBuffer()
    buffer.set('earth', 'map', 50 * SECOND, at(1.0))
    buffer.set('map', 'a', 60 * SECOND, at(1.0))
    buffer.set('map', 'b', 60 * SECOND, at(3.0))
    assert buffer.lookup('a', 'b') == (60 * SECOND, at(2.0))


def test_a_loop_is_reported_with_all_frames():
    buffer = TransformBuffer()
    for parent, child in (('a', 'b'), ('b', 'c'), ('c', 'a'), ('w', 'x')):
        buffer.set(parent, child, SECOND, at(1.0))
    assert x_of(buffer, 'a', 'c', SECOND) == 2.0
    assert failure_of(buffer, 'x', 'c', SECOND) == (
        'lookup',
        (
            'The tf tree is invalid because it contains a loop.\nFrame b exists with parent a.\nFrame a exists with parent '
            'c.\nFrame c exists with parent b.\nFrame x exists with parent w.\n\n'
        ),
    )


def test_a_full_lookup_sees_each_frame_at_its_own_time():
    buffer = TransformBuffer()
    for second in (1, 2, 3):
        buffer.set('world', 'leader', second * SECOND, at(10.0 * second))
        buffer.set('world', 'follower', second * SECOND, at(1.0 * second))
    assert buffer.lookup_full('follower', 3 * SECOND, 'leader', SECOND, 'world') == (3 * SECOND, at(7.0))


def test_a_full_lookup_checks_all_names_even_when_they_are_equal():
    with pytest.raises(
        TransformFailure, match='"a" passed to lookupTransform argument target_frame does not exist'
    ):
        TransformBuffer().lookup_full('a', 1, 'a', 1, 'a')
    buffer = chain_of(1)
    with pytest.raises(
        TransformFailure, match='"z" passed to lookupTransform argument fixed_frame does not exist. '
    ):
        buffer.lookup_full('f0', 1, 'f1', 1, 'z')


def test_can_transform_says_why_not():
    buffer = chain_of(2)
    assert buffer.can_transform('f0', 'f2') == (True, '')
    assert buffer.can_transform('zz', 'zz') == (True, '')
    assert buffer.can_transform('f0', 'z') == (
        False,
        ('Invalid frame ID "z" passed to canTransform argument source_frame - frame does not exist'),
    )
    assert buffer.can_transform('', 'z')[1] == (
        'Invalid frame ID "" passed to canTransform argument target_frame - in tf2 frame_ids cannot be empty'
    )
    assert buffer.can_transform('f0', '/f1')[1] == (
        'Invalid frame ID "/f1" passed to canTransform argument source_frame - in tf2 frame_ids cannot start with '
        "a '/'"
    )
    assert buffer.can_transform('f0', 'f1', 7)[1].startswith(
        'Lookup would require extrapolation at time 0.000000'
    )
    assert buffer.can_transform_full('f0', SECOND, 'f2', 7, 'f1')[0] is False
    assert buffer.can_transform_full('f0', SECOND, 'f2', SECOND, 'f1') == (True, '')


@given(st.integers(1, 4), st.integers(0, 5 * SECOND))
def test_can_transform_and_lookup_agree(depth, time_ns):
    buffer = chain_of(depth, samples=3)
    possible, reason = buffer.can_transform('f0', f'f{depth}', time_ns)
    if possible:
        assert buffer.lookup('f0', f'f{depth}', time_ns)[0] == time_ns or time_ns == 0
    else:
        assert failure_of(buffer, 'f0', f'f{depth}', time_ns)[1] == reason


def test_clear_keeps_names_and_static_transforms():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.set('w', 's', 0, at(2.0), static=True)
    buffer.lookup('w', 'a')
    buffer.clear()
    assert buffer.frame_names() == ['a', 'w', 's']
    assert x_of(buffer, 'w', 's') == 2.0
    assert failure_of(buffer, 'w', 'a', SECOND) == (
        'extrapolation',
        (', when looking up transform from frame [a] to frame [w]'),
    )
    assert failure_of(buffer, 'w', 'a')[0] == 'connectivity'


def test_latest_common_time_names_itself():
    with pytest.raises(TransformFailure, match='"a" passed to get_latest_common_time does not exist. '):
        TransformBuffer().latest_common_time('a', 'b')


def test_the_chain_goes_over_the_first_common_ancestor():
    buffer = TransformBuffer()
    for parent, child in (('w', 'm'), ('m', 'a'), ('m', 'b'), ('b', 'c')):
        buffer.set(parent, child, SECOND, at(1.0))
    assert buffer.chain('a', 0, 'c', 0, 'm') == ['c', 'b', 'm', 'a']
    assert buffer.chain('a', 0, 'c', 0, 'a') == ['c', 'b', 'm', 'a']


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
    assert counted_steps(4096) - counted_steps(256) <= 6


def test_chains_of_a_thousand_links_are_the_limit():
    buffer = chain_of(1002)
    assert buffer.can_transform('f0', 'f1000', SECOND)[0]
    assert 'contains a loop' in failure_of(buffer, 'f0', 'f1002', SECOND)[1]

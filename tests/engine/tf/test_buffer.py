"""The buffer against facts_tf2.md: inserts, lookups, latest common time, reparenting, full lookups."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf import TransformBuffer
from edulaunch.engine.tf.transforms import IDENTITY

from .shapes import SECOND, at, chain_of, failure_of, x_of


def test_a_quaternion_of_another_length_is_normalised_silently():
    buffer = TransformBuffer()
    assert buffer.set('w', 'a', SECOND, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5)) == ()
    assert buffer.lookup('w', 'a')[1] == IDENTITY


def test_history_spans_the_cache_and_one_period():
    buffer = TransformBuffer()
    for second in range(1, 31):
        buffer.set('w', 'a', second * SECOND, at(float(second)))
    assert x_of(buffer, 'w', 'a', 19 * SECOND) == 19.0
    assert failure_of(buffer, 'w', 'a', 18 * SECOND)[1].startswith(
        'Lookup would require extrapolation into the past.  Requested time 18.000000 but the earliest data is at time 19.000000'
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


def test_the_latest_time_is_the_oldest_of_the_newest_stamps():
    buffer = TransformBuffer()
    for second in (1, 2, 3):
        buffer.set('w', 'a', second * SECOND, at(float(second)))
    for second in (1, 2):
        buffer.set('w', 'b', second * SECOND, at(0.0))
    buffer.set('b', 'c', 0, at(0.0), static=True)
    assert buffer.lookup('c', 'a') == (2 * SECOND, at(2.0))
    assert buffer.latest_common_time('c', 'a') == 2 * SECOND


def test_the_future_is_not_invented():
    buffer = TransformBuffer()
    for second in (1, 2):
        buffer.set('world', 'turtle1', second * SECOND, at(1.0))
    assert failure_of(buffer, 'world', 'turtle1', 2 * SECOND + 1)[1] == (
        'Lookup would require extrapolation into the future.  Requested time 2.000000 but the latest data '
        'is at time '
        '2.000000, when looking up transform from frame [turtle1] to frame [world]'
    )


def test_a_full_lookup_sees_each_frame_at_its_own_time():
    buffer = TransformBuffer()
    for second in (1, 2, 3):
        buffer.set('world', 'leader', second * SECOND, at(10.0 * second))
        buffer.set('world', 'follower', second * SECOND, at(1.0 * second))
    assert buffer.lookup_full('follower', 3 * SECOND, 'leader', SECOND, 'world') == (3 * SECOND, at(7.0))


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
        'Invalid frame ID "/f1" passed to canTransform argument source_frame - in tf2 frame_ids cannot start with a \'/\''
    )
    assert buffer.can_transform('f0', 'f1', 7)[1].startswith('Lookup would require extrapolation at time 0.000000')
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
    assert failure_of(buffer, 'w', 'a', SECOND) == ('extrapolation', (', when looking up transform from frame [a] to frame [w]'))
    assert failure_of(buffer, 'w', 'a')[0] == 'connectivity'

"""Failures and detours of lookups: other parents, other trees, loops."""

from __future__ import annotations

from edulaunch.engine.tf import TransformBuffer

from .shapes import SECOND, at, chain_of, failure_of, x_of


def test_frames_of_two_trees_are_not_connected():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.set('v', 'b', SECOND, at(1.0))
    for time_ns in (0, SECOND):
        assert failure_of(buffer, 'a', 'b', time_ns) == (
            'connectivity',
            (
                "Could not find a connection between 'a' and 'b' because they are not part of the same "
                'tree.Tf has two or '
                'more unconnected trees.'
            ),
        )


def test_a_new_parent_takes_over_at_once_and_old_times_keep_the_old_one():
    buffer = TransformBuffer()
    buffer.set('map', 'odom', 0, at(100.0), static=True)
    for second in (1, 2):
        buffer.set('map', 'base', second * SECOND, at(float(second)))
    for second in (3, 4):
        buffer.set('odom', 'base', second * SECOND, at(float(second)))
    assert [x_of(buffer, 'map', 'base', time) for time in (SECOND, int(2.5 * SECOND), 4 * SECOND, 0)] == [1.0, 2.0, 104.0, 104.0]


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
            'The tf tree is invalid because it contains a loop.\nFrame b exists with parent a.\nFrame a '
            'exists with parent '
            'c.\nFrame c exists with parent b.\nFrame x exists with parent w.\n\n'
        ),
    )


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


def test_the_chain_goes_over_the_first_common_ancestor():
    buffer = TransformBuffer()
    for parent, child in (('w', 'm'), ('m', 'a'), ('m', 'b'), ('b', 'c')):
        buffer.set(parent, child, SECOND, at(1.0))
    assert buffer.chain('a', 0, 'c', 0, 'm') == ['c', 'b', 'm', 'a']
    assert buffer.chain('a', 0, 'c', 0, 'a') == ['c', 'b', 'm', 'a']


def test_chains_of_a_thousand_links_are_the_limit():
    buffer = chain_of(1002)
    assert buffer.can_transform('f0', 'f1000', SECOND)[0]
    assert 'contains a loop' in failure_of(buffer, 'f0', 'f1002', SECOND)[1]

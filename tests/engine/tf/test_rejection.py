"""What an insert refuses, and in which words."""

from __future__ import annotations

from math import nan

import pytest

from edulaunch.engine.tf import TransformBuffer

from .shapes import SECOND, at


def test_a_zero_quaternion_is_refused_twice_over():
    texts = [text for _, text in TransformBuffer().set('w', 'a', SECOND, (0.0,) * 7, 'me')]
    assert texts == [
        (
            'TF_NAN_INPUT: Ignoring transform for child_frame_id "a" from authority "me" because of a nan '
            'value in the transform (0.000000 0.000000 0.000000) (-nan -nan -nan -nan)'
        ),
        (
            'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "a" from authority "me" '
            'because of an invalid quaternion in the transform (-nan -nan -nan -nan)'
        ),
    ]


def test_a_known_frame_is_checked_as_well_as_a_new_one():
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    ((severity, text),) = buffer.set('w', 'a', 2 * SECOND, (nan, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    assert (severity, text) == (
        'error',
        (
            'TF_NAN_INPUT: Ignoring transform for child_frame_id "a" from authority "default_authority" '
            'because of a nan '
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
                (
                    'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  '
                    'child_frame_id "a" '
                    'because they are the same'
                )
            ],
        ),
        ('w', '', ['TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because child_frame_id not set ']),
        ('', 'a', [('TF_NO_FRAME_ID: Ignoring transform with child_frame_id "a"  from authority "me" because frame_id not set')]),
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
                'TF_OLD_DATA ignoring data from the past for frame a at time 1700000005.000000 according '
                'to authority '
                'default_authority\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained'
            ),
        ),
    )

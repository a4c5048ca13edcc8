"""The checks of frame names."""

from __future__ import annotations

import pytest

from edulaunch.engine.tf import TransformBuffer, TransformFailure
from edulaunch.engine.tf.frame_names import problem
from edulaunch.engine.tf.transforms import IDENTITY

from .shapes import SECOND, at, chain_of, failure_of, x_of


def test_one_leading_slash_is_taken_off_when_inserting_and_refused_when_looking_up():
    buffer = TransformBuffer()
    assert buffer.set('/w', '/a', SECOND, at(1.0)) == ()
    assert buffer.frame_names() == ['a', 'w']
    assert x_of(buffer, 'w', 'a') == 1.0
    assert failure_of(buffer, '/w', 'a') == (
        'invalid_argument',
        ('Invalid argument "/w" passed to lookupTransform argument target_frame - in tf2 frame_ids cannot start with a \'/\''),
    )


def test_names_are_checked_target_first():
    buffer = TransformBuffer()
    assert failure_of(buffer, 'a', 'b') == ('lookup', '"a" passed to lookupTransform argument target_frame does not exist. ')
    buffer.set('w', 'a', SECOND, at(1.0))
    assert failure_of(buffer, 'a', '') == (
        'invalid_argument',
        ('Invalid argument "" passed to lookupTransform argument source_frame - in tf2 frame_ids cannot be empty'),
    )


def test_equal_names_give_the_identity_before_any_check():
    buffer = TransformBuffer()
    buffer.set('w', 'a', 3 * SECOND, at(1.0))
    for name in ('', '/x', 'unknown'):
        assert buffer.lookup(name, name, 7) == (7, IDENTITY)
    assert buffer.lookup('a', 'a') == (3 * SECOND, IDENTITY)
    assert buffer.lookup('w', 'w') == (0, IDENTITY)


def test_a_full_lookup_checks_all_names_even_when_they_are_equal():
    with pytest.raises(TransformFailure, match='"a" passed to lookupTransform argument target_frame does not exist'):
        TransformBuffer().lookup_full('a', 1, 'a', 1, 'a')
    buffer = chain_of(1)
    with pytest.raises(TransformFailure, match='"z" passed to lookupTransform argument fixed_frame does not exist. '):
        buffer.lookup_full('f0', 1, 'f1', 1, 'z')


def test_latest_common_time_names_itself():
    with pytest.raises(TransformFailure, match='"a" passed to get_latest_common_time does not exist. '):
        TransformBuffer().latest_common_time('a', 'b')


def test_a_name_that_is_no_text_is_a_type_error():
    with pytest.raises(TypeError, match='a frame name must be str, not NoneType'):
        TransformBuffer().lookup(None, 'a', SECOND)


def test_can_transform_names_the_first_frame_that_it_does_not_know():
    assert problem({'w', 'a'}, 'w', 'a') == ''
    assert problem({'w', 'a'}, 'w', 'a', 'w') == ''
    unknown = 'Invalid frame ID "b" passed to canTransform argument source_frame - frame does not exist'
    assert problem({'w'}, 'w', 'b') == problem({'w'}, 'w', 'b', 'c') == unknown
    empty = 'Invalid frame ID "" passed to canTransform argument target_frame - in tf2 frame_ids cannot be empty'
    assert problem({'w'}, '', 'b') == empty

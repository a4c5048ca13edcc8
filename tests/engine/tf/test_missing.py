"""The help about an unknown frame."""

from __future__ import annotations

import pytest

from edulaunch.engine.tf import TransformBuffer, explain_missing

from .shapes import SECOND, at


def test_a_known_frame_needs_no_help():
    buffer = TransformBuffer()
    buffer.set('world', 'turtle1', SECOND, at(1.0))
    assert explain_missing(buffer, 'world') is None


@pytest.mark.parametrize(
    ('name', 'words'),
    [
        ('turtel1', "did you mean 'turtle1'"),
        ('/turtle1', "no leading slash; try 'turtle1'"),
        ('base_link', 'known frames: turtle1, world'),
    ],
)
def test_an_unknown_frame_is_set_against_the_known_ones(name, words):
    buffer = TransformBuffer()
    buffer.set('world', 'turtle1', SECOND, at(1.0))
    assert words in (explain_missing(buffer, name) or '')


def test_an_empty_buffer_asks_for_the_broadcaster():
    assert 'the buffer is empty' in (explain_missing(TransformBuffer(), 'world') or '')

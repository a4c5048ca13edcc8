"""What only follows from another finding is not told beside it, if both are about one node; tf's frames belong to all nodes."""

from __future__ import annotations

import pytest

from edulaunch.advice import Finding, found
from edulaunch.advice.judging import in_order


def slept(node: str) -> Finding:
    return found('node', node)._replace(rule='time.sleep-in-callback')


def lagging(node: str) -> Finding:
    return found('topic', '/chatter', node=node)._replace(rule='messages.not-taken')


@pytest.mark.parametrize(
    ('node', 'rules'), [('/slow', ['time.sleep-in-callback']), ('/other', ['messages.not-taken', 'time.sleep-in-callback'])]
)
def test_a_consequence_is_hidden_for_the_same_node_only(node: str, rules: list[str]) -> None:
    assert sorted(one.rule for one in in_order([lagging(node), slept('/slow')])) == rules


def test_frames_belong_to_all_nodes() -> None:
    cause = found('frame', 'turtle1', node='/broadcaster')._replace(rule='tf.zero-rotation')
    empty = found('frame', 'turtle1', node='/listener')._replace(rule='tf.empty-buffer')
    assert [one.rule for one in in_order([empty, cause])] == ['tf.zero-rotation']


def test_a_death_is_explained_for_the_same_program_only() -> None:
    early = found('frame', 'camera', node='/where', process='where-1')._replace(rule='tf.lookup-early')
    deaths = [found('process', name)._replace(rule='programs.died') for name in ('where-1', 'other-2')]
    assert [(one.rule, one.name) for one in in_order([early, *deaths])] == [
        ('programs.died', 'other-2'),
        ('tf.lookup-early', 'camera'),
    ]


@pytest.mark.parametrize(
    ('error', 'rules'),
    [('LookupException: "x" ...', ['tf.unknown-frame']), ('TypeError: no', ['programs.died', 'tf.unknown-frame'])],
)
def test_a_death_of_another_error_is_no_consequence_of_a_lookup(error: str, rules: list[str]) -> None:
    lookup = found('frame', 'x', node='/where', process='where-1')._replace(rule='tf.unknown-frame')
    died = found('process', 'where-1', error=error)._replace(rule='programs.died')
    assert sorted(one.rule for one in in_order([lookup, died])) == rules

"""Transforms as they were broadcast: whose child, by whom, when, with which numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import Broadcasts, broadcast_place, broadcasts, by_child, fact_place, node_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '09_broadcaster_and_listener'
STATIC = '08_static_broadcaster'


def _found(recording: Recording, one: Broadcasts, **facts: Any) -> Finding:
    file, line = broadcast_place(recording, one.node, '/tf_static' if one.is_static else '/tf')
    facts = {'node': one.node, 'parent': one.parent, 'time_s': one.first_s, **facts}
    return found('frame', one.child, file=file, line=line, **facts)


def _odd(recording: Recording, what: str) -> Iterator[Finding]:
    for one in broadcasts(recording):
        if what in one.odd:
            time_s, times = one.odd[what]
            yield _found(recording, one, time_s=time_s, times=times, lag_s=round(abs(one.lag_s), 1))


@rule(
    'tf.two-parents',
    what="the frame '{frame}' has more than one parent: {parents}; they are broadcast by {nodes}",
    why='tf is a tree: each frame has one parent, and the last broadcast wins, so the frame jumps to and fro',
    do="give one of the two another child_frame_id, or turn one link round so that '{frame}' is the parent",
    lesson=LESSON,
    level='error',
    hides=('tf.separate-trees',),
)
def two_parents(recording: Recording) -> Iterator[Finding]:
    """Broadcast with both within the run; the links of several nodes count together."""
    for links in by_child(recording).values():
        parents = list(dict.fromkeys(link.parent.removeprefix('/') for link in links))
        if len(parents) > 1:
            yield _found(recording, links[-1], parents=parents, nodes=list(dict.fromkeys(link.node for link in links)))


@rule(
    'tf.two-broadcasters',
    what="the frame '{frame}' is broadcast by two nodes: {first} and {second}",
    why='a listener mixes both, so the frame jumps between them',
    do='stop one of them, or give one another child_frame_id',
    lesson=LESSON,
)
def two_broadcasters(recording: Recording) -> Iterator[Finding]:
    """In the same parent, at the same time, from nodes of two names. Of two static ones the first was still there."""
    ended = {node.name: node.ended_s for node in recording.nodes}
    for links in by_child(recording).values():
        for one, other in zip(links, links[1:], strict=False):
            overlap = one.first_ns <= other.last_ns and other.first_ns <= one.last_ns
            end_s = ended.get(one.node)
            stays = one.is_static and (end_s is None or end_s > other.first_s)
            if one.parent == other.parent and one.node != other.node and (overlap or stays):
                yield _found(recording, other, first=one.node, second=other.node)


@rule(
    'tf.static-repeated',
    what="{node} sends the static transform of '{frame}' again with other values, and nobody gets them",
    why='a static transform is sent once: StaticTransformBroadcaster of Jazzy keeps the first values of a frame',
    do='use TransformBroadcaster and /tf for a frame that moves, or work out the final values before you send them',
    lesson=STATIC,
    level='error',
)
def static_repeated(recording: Recording) -> Iterator[Finding]:
    """By one program; two programs with different values are two broadcasters."""
    for fact in recording.facts:
        if fact.kind == 'static transform repeated':
            file, line = fact_place(recording, fact)
            yield found(
                'frame', fact.data['child'], file=file, line=line, time_s=fact.time_s, node=node_of(recording, fact.process)
            )


@rule(
    'tf.static-and-moving',
    what="the frame '{frame}' is broadcast as static by {first} and as moving by {second}",
    why='a frame is one or the other: whichever arrives last throws away what is known of the other kind',
    do="broadcast '{frame}' on /tf only, or on /tf_static only",
    lesson=STATIC,
)
def static_and_moving(recording: Recording) -> Iterator[Finding]:
    """The same frame in the same parent on /tf and on /tf_static."""
    for links in by_child(recording).values():
        for one in links:
            other = next((link for link in links if link.parent == one.parent and not link.is_static), None)
            if one.is_static and other is not None:
                yield _found(recording, other, first=one.node, second=other.node)


@rule(
    'tf.slash-in-name',
    what="{node} broadcasts the frame '{frame}' with the parent '{parent}': frame names of tf2 have no leading slash",
    why='tf2 takes the slash away, and a lookup with it fails',
    do='leave the slash out of frame_id and child_frame_id',
    lesson=LESSON,
)
def slash_in_name(recording: Recording) -> Iterator[Finding]:
    """In the name of the frame or of its parent."""
    return (_found(recording, one) for one in broadcasts(recording) if one.child.startswith('/') or one.parent.startswith('/'))


@rule(
    'tf.own-parent',
    what="{node} broadcasts the frame '{frame}' as its own parent",
    why='tf2 ignores such a transform, so the frame never gets a place',
    do='set header.frame_id to the frame it is measured in, such as "world", and child_frame_id to the one that moves',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def own_parent(recording: Recording) -> Iterator[Finding]:
    """Parent and child have the same name."""
    return (_found(recording, one) for one in broadcasts(recording) if one.child and one.child == one.parent)


@rule(
    'tf.nameless',
    what="{node} broadcasts a transform of '{frame}' in '{parent}': one of the two names is empty",
    why='tf2 ignores a transform that does not say which frame it places, and in which',
    do='set both header.frame_id and child_frame_id before you send it',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def nameless(recording: Recording) -> Iterator[Finding]:
    """An empty parent or child."""
    return (_found(recording, one) for one in broadcasts(recording) if not (one.child and one.parent))


@rule(
    'tf.zero-rotation',
    what="{node} broadcasts '{frame}' with the rotation (0, 0, 0, 0), which is none: {times} of {count}",
    why='tf2 refuses such a transform, so the frame never gets a place',
    do='set rotation.w = 1.0 for "not turned", or fill it from an angle: x, y, z, w = quaternion_from_euler(0, 0, theta)',
    lesson=STATIC,
    level='error',
    hides=('tf.empty-buffer',),
)
def zero_rotation(recording: Recording) -> Iterator[Finding]:
    """All four numbers are 0, as after `Quaternion(x=0.0, y=0.0, z=0.0, w=0.0)`."""
    counts = {(one.node, one.child): one.count for one in broadcasts(recording)}
    for finding in _odd(recording, 'zero'):
        yield finding._replace(facts={**finding.facts, 'count': counts[finding.facts['node'], finding.name]})


@rule(
    'tf.not-a-number',
    what="{node} broadcasts '{frame}' with a number that is none (nan)",
    why='tf2 refuses such a transform, so the frame stays where it was',
    do='look for a division by zero, or the root of a negative number, in what you send',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def not_a_number(recording: Recording) -> Iterator[Finding]:
    """nan in the translation or rotation."""
    return _odd(recording, 'nan')


@rule(
    'tf.unstamped',
    what="{node} broadcasts '{frame}' without a time: its stamp is 0",
    why='tf2 orders transforms by their stamps; with 0 the frame seems never to move',
    do='set the stamp each time you send: t.header.stamp = self.get_clock().now().to_msg()',
    lesson=LESSON,
    level='error',
)
def unstamped(recording: Recording) -> Iterator[Finding]:
    """Moving frames only: static ones need no stamp."""
    return _odd(recording, 'unstamped')


@rule(
    'tf.other-clock',
    what="{node} stamps '{frame}' by another clock: {lag_s} s away from the time of the others",
    why='lookups that join it with other frames find no common time',
    do='take the time from the node: self.get_clock().now(), and give all nodes the same value of use_sim_time',
    lesson=LESSON,
    level='error',
    hides=('tf.lookup-past', 'tf.lookup-future'),
)
def other_clock(recording: Recording) -> Iterator[Finding]:
    """Stamps far from the moment of broadcast, unless some node publishes a /clock of its own."""
    return iter(()) if '/clock' in recording.topics else _odd(recording, 'clock')


@rule(
    'tf.listener-not-kept',
    what='the TransformListener of {node} is thrown away as soon as it is made',
    why='Python deletes what nothing holds, and with the listener its buffer stops being filled',
    do='keep it in the node: self.tf_listener = TransformListener(self.tf_buffer, self)',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def listener_not_kept(recording: Recording) -> Iterator[Finding]:
    """It was deleted while its node lived on; not at the end of the program."""
    ends = {process.name: process.ended_s for process in recording.processes}
    for fact in recording.facts:
        end = ends.get(fact.process or '')
        if fact.kind == 'listener dropped' and (end is None or end > fact.time_s):
            file, line = fact_place(recording, fact)
            yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s)

"""Rules about broadcast transforms: their frames, broadcasters, times and values."""

from __future__ import annotations

import linecache
import re
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
            again = times if len(one.stamps) == 1 < times else None
            yield _found(recording, one, time_s=time_s, times=times, lag_s=round(abs(one.lag_s), 1), again=again)


@rule(
    'tf.two-parents',
    what="the frame '{frame}' has several parents ({parents}), broadcast by {nodes}",
    why='each frame in tf has one parent and the latest transform wins, so the frame jumps between the parents',
    do="change one of the two child_frame_id values, or reverse one transform to make '{frame}' the parent",
    lesson=LESSON,
    level='error',
    hides=('tf.separate-trees',),
)
def two_parents(recording: Recording) -> Iterator[Finding]:
    """Report a frame that was broadcast with two parents in one run, by the same node or by several nodes."""
    for links in by_child(recording).values():
        parents = list(dict.fromkeys(link.parent.removeprefix('/') for link in links))
        if len(parents) > 1:
            yield _found(recording, links[-1], parents=parents, nodes=list(dict.fromkeys(link.node for link in links)))


@rule(
    'tf.two-broadcasters',
    what="two nodes broadcast the frame '{frame}': {first} and {second}",
    why=(
        "both transforms of '{still}' are static, and tf2 keeps only the one that arrives last",
        'a listener receives both transforms, so the frame jumps between two positions',
    ),
    do='stop one of the nodes, or give it another child_frame_id',
    lesson=LESSON,
)
def two_broadcasters(recording: Recording) -> Iterator[Finding]:
    """Report a frame that two nodes broadcast with the same parent at the same time.

    If both transforms are static, the node that sent the first transform must still exist.
    """
    ended = {node.name: node.ended_s for node in recording.nodes}
    for links in by_child(recording).values():
        for one, other in zip(links, links[1:], strict=False):
            overlap = one.first_ns <= other.last_ns and other.first_ns <= one.last_ns
            end_s = ended.get(one.node)
            stays = one.is_static and (end_s is None or end_s > other.first_s)
            if one.parent == other.parent and one.node != other.node and (overlap or stays):
                still = one.child if one.is_static and other.is_static else None
                yield _found(recording, other, first=one.node, second=other.node, still=still)


@rule(
    'tf.static-repeated',
    what="{node} sends the static transform of '{frame}' again with other values, and no listener receives them",
    why='in Jazzy, StaticTransformBroadcaster keeps the first transform that it sends for a frame',
    do='use TransformBroadcaster and /tf for a moving frame, or compute the final values before you send them',
    lesson=STATIC,
    level='error',
)
def static_repeated(recording: Recording) -> Iterator[Finding]:
    """Report a static transform that one program sends repeatedly.

    If two programs send different values, another rule reports them.
    """
    for fact in recording.facts:
        if fact.kind == 'static transform repeated':
            file, line = fact_place(recording, fact)
            yield found(
                'frame', fact.data['child'], file=file, line=line, time_s=fact.time_s, node=node_of(recording, fact.process)
            )


@rule(
    'tf.static-and-moving',
    what="{first} broadcasts the frame '{frame}' as static, and {second} broadcasts it as moving",
    why='a frame is either static or moving, and the latest transform replaces all transforms of the other kind',
    do="broadcast '{frame}' either on /tf or on /tf_static",
    lesson=STATIC,
)
def static_and_moving(recording: Recording) -> Iterator[Finding]:
    """Report a frame that has the same parent on /tf and on /tf_static."""
    for links in by_child(recording).values():
        for one in links:
            other = next((link for link in links if link.parent == one.parent and not link.is_static), None)
            if one.is_static and other is not None:
                yield _found(recording, other, first=one.node, second=other.node)


@rule(
    'tf.slash-in-name',
    what="{node} broadcasts the frame '{frame}' with the parent '{parent}', but frame names in tf2 have no leading slash",
    why='tf2 removes the slash, and a lookup with the slash fails',
    do='remove the slash from frame_id and child_frame_id',
    lesson=LESSON,
)
def slash_in_name(recording: Recording) -> Iterator[Finding]:
    """Report a slash at the start of a frame's name or of its parent's name, once for each node.

    Skip a robot_state_publisher with the frame_prefix '/'. This prefix is common without a namespace, and tf2 removes the
    slash.
    """
    told: set[str] = set()
    for one in broadcasts(recording):
        is_slashed = one.child.startswith('/') or one.parent.startswith('/')
        if is_slashed and one.node not in told and one.node not in _prefixing(recording):
            told.add(one.node)
            yield _found(recording, one)


def _prefixing(recording: Recording) -> set[str]:
    """Return the nodes whose parameter frame_prefix has the value '/'."""
    return {node for _, node, name, value, _ in recording.rows('parameters') if (name, value) == ('frame_prefix', '/')}


@rule(
    'tf.own-parent',
    what="{node} broadcasts the frame '{frame}' as its own parent",
    why='tf2 ignores such a transform, so the frame never gets a position',
    do='set header.frame_id to the reference frame, such as "world", and child_frame_id to the frame that moves',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer', 'tf.unknown-frame'),
)
def own_parent(recording: Recording) -> Iterator[Finding]:
    """Report a transform whose parent and child have the same name."""
    return (_found(recording, one) for one in broadcasts(recording) if one.child and one.child == one.parent)


@rule(
    'tf.nameless',
    what="{node} broadcasts a transform from '{parent}' to '{frame}', but one of these names is empty",
    why='tf2 ignores a transform in which the name of a frame is missing',
    do='set both header.frame_id and child_frame_id before you send the transform',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer', 'tf.unknown-frame'),
)
def nameless(recording: Recording) -> Iterator[Finding]:
    """Report a transform without the name of its parent or its child."""
    return (_found(recording, one) for one in broadcasts(recording) if not (one.child and one.parent))


@rule(
    'tf.zero-rotation',
    what=(
        "{node} broadcasts '{frame}' with an invalid rotation: a quaternion has the length 1, not {length}",
        "{node} broadcasts '{frame}' with the invalid rotation (0, 0, 0, 0), in {times} of {count} messages",
    ),
    why='tf2 rejects such a transform, so the frame never gets a position',
    do=(
        'write z = math.sin(theta / 2) and w = math.cos(theta / 2) in place of a rotation of length {length}',
        'set rotation.w = 1.0 for no rotation, or compute it from an angle: x, y, z, w = quaternion_from_euler(0, 0, theta)',
    ),
    lesson=STATIC,
    level='error',
    hides=('tf.empty-buffer',),
)
def zero_rotation(recording: Recording) -> Iterator[Finding]:
    """Report a rotation of four zeros, as in `Quaternion(x=0.0, y=0.0, z=0.0, w=0.0)`, or a rotation whose length is not 1."""
    for one in broadcasts(recording):
        if 'long' in one.odd:
            yield _found(recording, one, time_s=one.odd['long'][0], length=round(one.length, 2))
    counts = {(one.node, one.child): one.count for one in broadcasts(recording)}
    for finding in _odd(recording, 'zero'):
        yield finding._replace(facts={**finding.facts, 'count': counts[finding.facts['node'], finding.name]})


@rule(
    'tf.not-a-number',
    what="{node} broadcasts '{frame}' with an invalid number (nan)",
    why='tf2 rejects such a transform, so the frame keeps its last position',
    do='look for a division by zero, or the square root of a negative number, in the values that you send',
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def not_a_number(recording: Recording) -> Iterator[Finding]:
    """Report a translation or rotation that contains nan."""
    return _odd(recording, 'nan')


@rule(
    'tf.unstamped',
    what="{node} broadcasts '{frame}' with a time stamp of 0",
    why='tf2 sorts transforms by their time stamps, so with a stamp of 0 the frame never moves',
    do='set the time stamp each time you send: t.header.stamp = self.get_clock().now().to_msg()',
    lesson=LESSON,
    level='error',
)
def unstamped(recording: Recording) -> Iterator[Finding]:
    """Report moving frames without a time stamp. Static frames do not need a time stamp."""
    return _odd(recording, 'unstamped')


@rule(
    'tf.other-clock',
    what=(
        "{node} sends {again} transforms of '{frame}' with the same time stamp",
        "{node} stamps '{frame}' with a clock that differs from the clock of the other nodes by {lag_s} s",
    ),
    why=(
        'tf2 keeps only one of {again} transforms with the same time stamp, so the frame does not move',
        'a lookup between this frame and another frame finds no common time',
    ),
    do=(
        'set the stamp before each of the {again} transforms, not once: t.header.stamp = self.get_clock().now().to_msg()',
        'get the time with self.get_clock().now(), and set use_sim_time to the same value in all nodes',
    ),
    lesson=LESSON,
    level='error',
    hides=('tf.lookup-past', 'tf.lookup-future', 'turtlesim.wall'),
)
def other_clock(recording: Recording) -> Iterator[Finding]:
    """Report time stamps that differ greatly from the time of the broadcast, unless a node publishes /clock."""
    return iter(()) if '/clock' in recording.topics else _odd(recording, 'clock')


@rule(
    'tf.listener-not-kept',
    what=(
        '{node} replaces {kept} by a new TransformListener each time this line runs, and Python deletes the old one',
        'Python deletes the TransformListener of {node} as soon as it is created',
    ),
    why='Python deletes an object that nothing refers to, and the buffer then receives no transforms',
    do=(
        'create the Buffer and {kept} only once, in __init__',
        'store it in an attribute of the node: self.tf_listener = TransformListener(self.tf_buffer, self)',
    ),
    lesson=LESSON,
    level='error',
    hides=('tf.empty-buffer',),
)
def listener_not_kept(recording: Recording) -> Iterator[Finding]:
    """Report a TransformListener that Python deleted while its node and its program still existed."""
    ends = {process.name: process.ended_s for process in recording.processes}
    for fact in recording.facts:
        end = ends.get(fact.process or '')
        if fact.kind == 'listener dropped' and (end is None or end > fact.time_s):
            file, line = fact_place(recording, fact)
            kept = re.match(r'\s*(self\.\w+)\s*=', linecache.getline(file or '', line or 0))
            yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s, kept=kept and kept[1])

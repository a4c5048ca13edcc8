"""Rules about names in tf: transforms on another topic, prefixes of frames, and a swapped parent and child."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.recordings.turtles import turtles
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import TF_TYPE, broadcast_place, broadcasts, ends_by_name, frame_names, node_of, node_place

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '09_broadcaster_and_listener'
ENOUGH = 5
"""With at least this many equal transforms, two series have the same cause."""


@rule(
    'tf.other-topic',
    what="{node} looks up '{frame}', which {other} broadcasts on {topic}, but {node} listens on {heard}",
    why='transforms reach a listener only on its own topics; a remapping of /tf must apply to all nodes that share transforms',
    do="give {node} the same namespace and the same remappings: remappings=[('/tf', 'tf'), ('/tf_static', 'tf_static')]",
    lesson=LESSON,
    level='error',
    hides=('tf.unknown-frame', 'tf.empty-buffer', 'programs.died', 'messages.nobody-listens', 'messages.other-topic'),
)
def other_topic(recording: Recording) -> Iterator[Finding]:
    """Report a lookup of a frame that is broadcast on a topic to which the node's listener does not subscribe."""
    failed = [fact for fact in recording.facts if fact.kind == 'lookup failed' and fact.data['unknown']]
    if not failed:
        return
    sent: dict[str, tuple[str, str]] = {}
    topics = [end.name for end in recording.ends if end.kind == 'publisher' and end.type == TF_TYPE]
    for topic in dict.fromkeys(topics):
        for _, node, wire in recording.published(topic, TF_TYPE)[:100]:
            for _, _, parent, child, *_ in wire[0]:
                for name in (parent, child):
                    sent.setdefault(name.removeprefix('/'), (topic, node))
    for fact in failed:
        if sent:
            node = node_of(recording, fact.process)
            heard = {end.name for end in recording.ends if (end.kind, end.node, end.type) == ('subscription', node, TF_TYPE)}
            missing = [name for name in fact.data['unknown'] if name and sent.get(name, ('', ''))[0] not in {'', *heard}]
            if heard and missing:
                topic, other = sent[missing[-1]]
                file, line = node_place(recording, node)
                facts = {'node': node, 'other': other, 'topic': topic, 'process': fact.process, 'heard': sorted(heard)[0]}
                yield found('frame', missing[-1], file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'tf.frame-prefix',
    what="frame_prefix of {node} is '{prefix}', so its frames have names such as '{joined}', but this run uses '{wanted}'",
    why='robot_state_publisher puts the prefix before each name as it is, without a slash between them',
    do="write 'frame_prefix': '{prefix}/'",
    lesson='12_urdf',
    level='error',
    hides=('tf.unknown-frame', 'tf.separate-trees'),
)
def frame_prefix(recording: Recording) -> Iterator[Finding]:
    """Report a frame_prefix without a slash at its end, if a lookup or another broadcaster uses the name with the slash."""
    known = frame_names(recording)
    asked = {
        name for fact in recording.facts if fact.kind == 'lookup failed' for name in (fact.data['target'], fact.data['source'])
    }
    for node in recording.nodes:
        prefix = recording.parameters(node.name).get('frame_prefix')
        text = prefix.value if prefix is not None else ''
        if isinstance(text, str) and text and text[-1] not in '/_':
            own = [name for one in broadcasts(recording) if one.node == node.name for name in (one.parent, one.child)]
            for name in dict.fromkeys(own):
                wanted = f'{text}/{name.removeprefix(text)}'
                if name.startswith(text) and wanted in {*known, *asked}:
                    file, line = node_place(recording, node.name)
                    facts: dict[str, Any] = {'node': node.name, 'prefix': text, 'joined': name, 'wanted': wanted}
                    yield found('frame', wanted, file=file, line=line, **facts)
                    break


@rule(
    'tf.swapped',
    what="{node} broadcasts '{frame}' as a child of '{parent}', but sends the position of {parent} in '{frame}'",
    why='header.frame_id is the parent, and the transform is the position of child_frame_id in the parent',
    do="write header.frame_id = '{frame}' and child_frame_id = '{parent}'",
    lesson=LESSON,
    level='error',
    hides=('tf.two-parents', 'tf.two-broadcasters', 'tf.loop', 'tf.unknown-frame', 'tf.separate-trees', 'turtlesim.wall'),
)
def swapped(recording: Recording) -> Iterator[Finding]:
    """Report a broadcaster that sends the pose of a turtle in a transform in which the turtle is the parent."""
    poses = {turtle.rpartition('/')[2]: turtle for turtle in turtles(recording)}
    ends = ends_by_name(recording)
    for one in broadcasts(recording):
        turtle = poses.get(one.parent.removeprefix('/'))
        if turtle is None or one.is_static or one.count < ENOUGH or one.child in poses:
            continue
        if all(end.node != one.node for end in ends.get(('subscription', f'{turtle}/pose'), ())):
            continue
        at = {(round(wire[0], 3), round(wire[1], 3)) for _, wire in recording.wires(f'{turtle}/pose', 'turtlesim/msg/Pose')}
        sent = [
            (round(x, 3), round(y, 3))
            for _, node, wire in recording.published('/tf', TF_TYPE)
            for _, _, parent, child, x, y, *_ in wire[0]
            if (node, parent, child) == (one.node, one.parent, one.child)
        ]
        if all(place in at for place in sent) and any(any(place) for place in sent):
            file, line = broadcast_place(recording, one.node, '/tf')
            yield found('frame', one.child, file=file, line=line, time_s=one.first_s, node=one.node, parent=one.parent)

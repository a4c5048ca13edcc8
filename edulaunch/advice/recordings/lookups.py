"""Rules about tf lookups that failed until the end of the run."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import broadcast_place, broadcasts, fact_place, frame_names, node_of, root_of
from edulaunch.engine.nearest import nearest, nearest_spelling

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import Fact

LESSON = '09_broadcaster_and_listener'
_EXTRAPOLATION = re.compile(
    r'into the (future|past)\.\s+Requested time ([\d.]+) but the (?:latest|earliest) data is at time ([\d.]+)'
)


def _lookups(recording: Recording) -> Iterator[Fact]:
    return (fact for fact in recording.facts if fact.kind == 'lookup failed')


def _found(recording: Recording, fact: Fact, frame: str, **facts: Any) -> Finding:
    file, line = fact_place(recording, fact)
    pair = {
        'target': fact.data['target'],
        'source': fact.data['source'],
        'node': node_of(recording, fact.process),
        'process': fact.process,
    }
    return found('frame', frame, file=file, line=line, time_s=fact.time_s, **pair, **facts)


@rule(
    'tf.unknown-frame',
    what=("{node} looks up the frame '{frame}', which no node broadcasts",),
    why='the lookup can never succeed, so code that waits for it waits forever',
    do=(
        "write '{near}' if you mean that frame",
        "write LaunchConfiguration('{argument}') in place of the string '{argument}'",
        "start the node that broadcasts '{frame}', or look up one of these frames: {frames}",
        'start a node that broadcasts transforms, because this run has no frames at all',
    ),
    lesson=LESSON,
    level='error',
    hides=('programs.died',),
)
def unknown_frame(recording: Recording) -> Iterator[Finding]:
    """Report a requested frame that never existed during the run. A frame that appeared late is not reported."""
    known = frame_names(recording)
    for fact in _lookups(recording):
        for name in fact.data['unknown'] if known else fact.data['unknown'][-1:]:
            if name and name.removeprefix('/') not in known:
                near, is_argument = (
                    _near(name.removeprefix('/'), known),
                    name in {each.name for each in recording.launch.declared},
                )
                facts: dict[str, Any] = {'near': near, 'argument': name if is_argument else None}
                yield _found(recording, fact, name, frames=sorted(known)[:8], **facts)


def _near(name: str, known: list[str]) -> str | None:
    """Return the known frame that the student probably meant, or None.

    A name that differs only in its number is the frame of another robot.
    """
    near = nearest(name, known)
    return None if near is None or near.rstrip('0123456789') == name.rstrip('0123456789') else near


@rule(
    'tf.leading-slash',
    what="{node} looks up '{frame}', but frame names in tf2 have no leading slash",
    why='every lookup with a leading slash fails',
    do="write '{plain}'",
    lesson=LESSON,
    level='error',
    hides=('programs.died',),
)
def leading_slash(recording: Recording) -> Iterator[Finding]:
    """Report a requested frame with a leading slash, if the frame exists without the slash."""
    known = frame_names(recording)
    for fact in _lookups(recording):
        for name in fact.data['unknown']:
            if name.startswith('/') and name[1:] in known:
                yield _found(recording, fact, name, plain=name[1:])


@rule(
    'tf.empty-buffer',
    what=(
        "{node} looks up '{frame}', but {sender} sent '{frame}' only once",
        "{node} looks up '{frame}' in a buffer that never received a transform, although a node broadcasts '{frame}'",
    ),
    why=(
        'the transform from {sender} is valid only at its time stamp, and later listeners do not receive it',
        'only a TransformListener fills a buffer, and only while its node spins',
    ),
    do=(
        'let {sender} send the transform repeatedly from a timer, or use StaticTransformBroadcaster if it never changes',
        'write self.tf_listener = TransformListener(self.tf_buffer, self) with the buffer of the lookup, and call '
        'rclpy.spin(node)',
    ),
    lesson=LESSON,
    level='error',
    hides=('programs.died', 'tf.lookup-past', 'tf.lookup-future'),
)
def empty_buffer(recording: Recording) -> Iterator[Finding]:
    """Report a lookup of a frame that is broadcast, if the buffer is empty, or if a moving frame was sent only once."""
    known = frame_names(recording)
    for fact in _lookups(recording):
        name = next((name for name in fact.data['unknown'] if name in known), None)
        if name is not None and not fact.data['frames'] and not _is_early(recording, fact):
            sent = [one for one in broadcasts(recording) if name in (one.child, one.parent)]
            is_once = all(one.first_ns == one.last_ns and not one.is_static for one in sent)
            yield _found(recording, fact, name, sender=sent[0].node if sent and is_once else None)
    once = [one for one in broadcasts(recording) if one.count == 1 and not one.is_static and 'clock' not in one.odd]
    for one in once:
        for fact, _ in (*_extrapolations(recording, 'past'), *_extrapolations(recording, 'future')):
            if one.child in (fact.data['target'], fact.data['source']):
                yield _found(recording, fact, one.child, sender=one.node)


@rule(
    'tf.lookup-early',
    what="{node} looks up '{frame}' only once, at its start, before it has received any transform",
    why='a node receives transforms only while it spins, so its constructor cannot look up a transform',
    do='look up the frame repeatedly in a timer with self.create_timer(0.1, self.on_timer), and ignore each TransformException',
    lesson=LESSON,
    level='error',
    hides=('programs.died',),
)
def lookup_early(recording: Recording) -> Iterator[Finding]:
    """Report a lookup of an existing frame that failed in the first 50 ms of the node and was not repeated."""
    known = frame_names(recording)
    for fact in _lookups(recording):
        name = next((name for name in reversed(fact.data['unknown']) if name in known), None)
        if name is not None and _is_early(recording, fact):
            yield _found(recording, fact, name)


def _is_early(recording: Recording, fact: Fact) -> bool:
    started = next((node.started_s for node in recording.nodes if node.process == fact.process), fact.time_s)
    return fact.last_s - started < MOMENT_S


MOMENT_S = 0.05


@rule(
    'tf.separate-trees',
    what="{node} looks up '{frame}' from '{target}', which is in another tree",
    why="one tree has the root '{first}', the other has the root '{second}', and no transform connects them",
    do=(
        "write LaunchConfiguration('{argument}') instead of the string '{argument}' where this frame is the parent",
        "write '{near}' instead of '{misspelt}' where this frame is the parent",
        "broadcast a transform between the trees, for example with the parent '{second}' and the child '{first}'",
    ),
    lesson=LESSON,
    level='error',
    hides=('programs.died',),
)
def separate_trees(recording: Recording) -> Iterator[Finding]:
    """Report a lookup between two existing frames that no chain of transforms ever connects."""
    known = frame_names(recording)
    for fact in _lookups(recording):
        target, source = fact.data['target'], fact.data['source']
        if target in known and source in known:
            first, second = root_of(recording, source), root_of(recording, target)
            if first != second:
                near = {root: _meant_root(recording, root) for root in (first, second)}
                misspelt = next((root for root in near if near[root] is not None), None)
                declared = {argument.name for argument in recording.launch.declared}
                argument = next((root for root in (first, second) if root in declared), None)
                facts = {'misspelt': misspelt, 'near': near.get(misspelt or ''), 'argument': argument}
                report = _found(recording, fact, source, first=first, second=second, **facts)
                sent = next((one for one in broadcasts(recording) if one.parent in (misspelt, argument)), None)
                if sent is not None:  # the mistake is in the program that broadcasts this parent
                    place = broadcast_place(recording, sent.node, '/tf_static' if sent.is_static else '/tf')
                    report = report._replace(file=place[0], line=place[1])
                yield report


def _meant_root(recording: Recording, root: str) -> str | None:
    """Return the frame of another tree of which a root is a misspelling, or None.

    Names with different numbers are not misspellings.
    """
    others = [frame for frame in frame_names(recording) if root_of(recording, frame) != root]
    near = nearest_spelling(root, [frame for frame in others if re.sub(r'\d+', '', frame) != re.sub(r'\d+', '', root)])
    is_close = near is not None and sorted(re.findall(r'\d+', near)) == sorted(re.findall(r'\d+', root))
    return near if is_close else None


@rule(
    'tf.lookup-future',
    what="{node} looks up '{frame}' {gap_s} s after the newest transform in its buffer",
    why='a transform takes time to arrive, so the buffer does not yet have a transform for the current time',
    do=(
        'pass rclpy.time.Time() to get the newest transform; this lookup blocks the node for {waited_s} s, so '
        'it receives no new transforms',
        'look up a time in the past, or pass rclpy.time.Time() as the time to get the newest transform',
    ),
    lesson=LESSON,
    level='error',
    hides=('programs.died', 'time.slow-callback'),
)
def lookup_future(recording: Recording) -> Iterator[Finding]:
    """Report lookups for a time that is later than all transforms in the buffer, if the last lookup failed, too."""
    for fact, gap_s in _extrapolations(recording, 'future'):
        yield _found(recording, fact, fact.data['source'], gap_s=gap_s, waited_s=fact.data['waited_s'] or None)


@rule(
    'tf.lookup-past',
    what="{node} looks up '{frame}' {gap_s} s before the oldest transform in its buffer",
    why='a buffer stores the last 10 s, and it has no transform from before the first broadcast',
    do='use a later time, wait until enough time has passed, or store more: Buffer(cache_time=Duration(seconds=30))',
    lesson=LESSON,
    level='error',
    hides=('programs.died',),
)
def lookup_past(recording: Recording) -> Iterator[Finding]:
    """Report lookups for a time that is earlier than all transforms in the buffer, if the last lookup failed, too."""
    for fact, gap_s in _extrapolations(recording, 'past'):
        yield _found(recording, fact, fact.data['source'], gap_s=gap_s)


def _extrapolations(recording: Recording, where: str) -> Iterator[tuple[Fact, float]]:
    stamped = {one.child for one in broadcasts(recording) if not one.odd.keys() & {'clock', 'unstamped'}}
    for fact in _lookups(recording):
        match = _EXTRAPOLATION.search(fact.data['text'])
        if match is not None and match[1] == where and stamped & {fact.data['target'], fact.data['source']}:
            yield fact, round(abs(float(match[2]) - float(match[3])), 3)

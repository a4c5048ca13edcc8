"""Rules about publishers and subscriptions whose topics have different names, and about several nodes that command one robot."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.recordings.matching import remappings
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import end_place, ends_by_name, is_ros_own, own_nodes, programs, speaker
from edulaunch.engine.graph.names import expand_name
from edulaunch.engine.nearest import nearest, nearest_spelling

if TYPE_CHECKING:
    from edulaunch.engine.graph.names import RemapRule
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import EndRecord

LESSON = '01_first_launch'
_PAIR = {'publisher': 'subscription', 'subscription': 'publisher'}


def lone_ends(recording: Recording, kind: str) -> list[EndRecord]:
    """Return the publishers or subscriptions whose topic never had an endpoint of the opposite kind.

    Return only the first endpoint of each node and topic.

    :param recording: the recording.
    :param kind: 'publisher' or 'subscription'.
    """
    ends = ends_by_name(recording)
    first: dict[tuple[str, str], EndRecord] = {}
    for (end_kind, name), rows in ends.items():
        if end_kind == kind and (_PAIR[kind], name) not in ends and not is_ros_own(name):
            for end in rows:
                first.setdefault((end.name, end.node), end)
    return list(first.values())


def meant(end: EndRecord, others: list[EndRecord]) -> EndRecord | None:
    """Return the endpoint that was probably meant as the partner of this endpoint, or None if there is no such endpoint.

    The partner has the same type, and a name with nearly the same spelling or the same last part.

    :param end: the endpoint without a partner.
    :param others: the endpoints of the opposite kind that have no partner.
    """
    same = {other.name: other for other in others if other.type == end.type and other.node != end.node}
    near = nearest_spelling(end.name, same)
    tail = end.name.rpartition('/')[2]
    alike = [name for name in same if name.rpartition('/')[2] == tail]
    name = near if near is not None else alike[0] if len(alike) == 1 else None
    return None if name is None else same[name]


def _sent(recording: Recording, end: EndRecord) -> bool:
    return bool(recording.topics[end.name].count)


@rule(
    'messages.other-topic',
    what='{node} publishes on {topic}, but no node subscribes to it; {other} subscribes to {near}, but no node publishes on it',
    why='ROS 2 connects topics by their full name with the namespace, so every letter and every slash counts',
    do=(
        "write a comma after the string '{first}': without it, Python joins this string to the next one",
        "write '{relative}' without the first slash in {outside}: with the slash, the name ignores the namespace of the node",
        "write '{right}' instead of '{wrong}' in the remappings of {remapped}",
        "write '{right}' instead of '{wrong}' in the command of {command}",
        "use the same name in both nodes, or add remappings=[('{near}', '{topic}')] to the Node of {subscriber}",
        "use the same name in both nodes, or add remappings=[('{topic}', '{near}')] to the Node of {publisher}",
        'use the same name in the remappings of both nodes',
    ),
    lesson=LESSON,
    level='error',
    hides=('messages.nobody-listens', 'messages.nobody-publishes'),
)
def other_topic(recording: Recording) -> Iterator[Finding]:
    """Report two topics of one type whose names are nearly equal, or have the same last part.

    One topic has only publishers, and the other topic has only subscriptions. At least one of the nodes belongs to a student.
    """
    subscriptions = lone_ends(recording, 'subscription')
    own = own_nodes(recording) | _commands(recording)
    for end in lone_ends(recording, 'publisher'):
        other = meant(end, subscriptions)
        is_moved = other is not None and _moved(recording, end.name)[1] not in (None, other.name)
        if other is None or is_moved or _is_outdone(recording, end, other) or _part_of_a_larger_launch(recording, end, other):
            continue
        if (end.node in own or other.node in own) and _sent(recording, end):
            repair = _repair(recording, end, other)
            is_first = speaker(recording, end.node) in (repair['remapped'], repair['command'], repair['publisher'])
            changed = end if is_first or (repair['first'] or ' ') + other.name == end.name else other
            mine = changed if changed.node in own else end if end.node in own else other
            mine = other if repair['outside'] == other.node else mine
            place = end_place(recording, mine.kind, mine.name, mine.node)
            yield found(
                'topic',
                end.name,
                file=place[0],
                line=place[1],
                time_s=end.made_s,
                node=speaker(recording, end.node),
                other=speaker(recording, other.node),
                near=other.name,
                **repair,
            )


def _repair(recording: Recording, end: EndRecord, other: EndRecord) -> dict[str, str | None]:
    """Return the facts for the advice: the node that uses the wrong name, or the nodes to which a remapping can be added."""
    facts: dict[str, str | None] = dict.fromkeys(
        ('first', 'relative', 'outside', 'right', 'wrong', 'remapped', 'command', 'subscriber', 'publisher')
    )
    facts['first'] = _joined(recording, end, other) or _joined(recording, other, end)
    how, other_how = _how_named(recording, end), _how_named(recording, other)
    for one, partner, known in ((end, other, how), (other, end, other_how)):
        namespace = one.node.rpartition('/')[0]
        if known is None and namespace and partner.name == namespace + one.name:
            facts |= {'relative': one.name[1:], 'outside': one.node}
    is_slip = nearest_spelling(end.name, [other.name]) is not None
    wrong, right = (other, end) if how is None else (end, other)
    lacks_slash = any(f'/{one.replacement}' == right.name for one in _remappings_of(recording, wrong))
    if (how is None) != (other_how is None) and (is_slip or lacks_slash or 'command' in (how, other_how)):
        written = right.name[1:] if lacks_slash else wrong.name
        facts |= {'right': right.name, 'wrong': written, how or other_how or '': speaker(recording, wrong.node)}
    if other_how is None:
        facts['subscriber'] = speaker(recording, other.node)
    elif how is None:
        facts['publisher'] = speaker(recording, end.node)
    return facts


def _how_named(recording: Recording, end: EndRecord) -> str | None:
    """Return where a student wrote the name of a topic.

    It is 'command' for a command line of `ros2 topic`, 'remapped' for a remapping, and None for the program itself.
    """
    process = next((each for each in recording.processes if each.name == programs(recording).get(end.node)), None)
    if process is not None and process.argv[1:2] == ['topic']:
        return 'command'
    namespace, _, name = end.node.rpartition('/')
    new = {expand_name(one.replacement, name, namespace or '/') for one in _remappings_of(recording, end)}
    return 'remapped' if end.name in new else None


def _remappings_of(recording: Recording, end: EndRecord) -> list[RemapRule]:
    """Return the remappings of the program of an endpoint."""
    program = programs(recording).get(end.node)
    return [one for process in recording.processes if process.name == program for one in remappings(process)]


def _joined(recording: Recording, end: EndRecord, other: EndRecord) -> str | None:
    """Return the first of two topic names that Python joined to one string because of a missing comma, or None."""
    first = end.name.removesuffix(other.name)
    is_namespace = end.node.startswith(f'{first}/')
    return first if first != end.name and first in recording.topics and not is_namespace else None


def _is_outdone(recording: Recording, end: EndRecord, other: EndRecord) -> bool:
    """Return whether another topic without a subscription resembles the topic of the subscription more.

    For example, a subscription to `/b/turtle1/pose` resembles `/a/turtle1/pose` more than `/a/turtle2/pose`.
    """
    shared = _shared_words(end.name, other.name)
    alone = (each.name for each in lone_ends(recording, 'publisher') if each.type == end.type)
    return any(_shared_words(name, other.name) > shared for name in alone)


def _shared_words(one: str, other: str) -> int:
    """Return the number of equal parts at the end of two names: 2 for `/a/turtle1/pose` and `/b/turtle1/pose`."""
    pairs = zip(reversed(one.split('/')), reversed(other.split('/')), strict=False)
    return next((number for number, (first, second) in enumerate(pairs) if first != second), 0)


def _moved(recording: Recording, topic: str) -> tuple[str, str] | tuple[None, None]:
    """Return the node that would subscribe to this topic without a remapping, and the topic to which it subscribes instead."""
    for process in recording.processes:
        for node in (each for each in recording.nodes if each.process == process.name):
            namespace, _, name = node.name.rpartition('/')
            for one in remappings(process):
                old, new = (expand_name(text, name, namespace or '/') for text in (one.match, one.replacement))
                if old == topic != new and one.node_name in (None, name) and any(new == known for known, _ in node.subscriptions):
                    return node.name, new
    return None, None


def _part_of_a_larger_launch(recording: Recording, end: EndRecord, other: EndRecord) -> bool:
    """Return whether the launch file remaps one of the two names on purpose, for a larger launch.

    No node has the namespace of this name. The names differ only in this namespace, and the namespace is not a misspelling.
    """
    for one, partner in ((end, other), (other, end)):
        space, _, rest = one.name[1:].partition('/')
        known, _, same = partner.name[1:].partition('/')
        if rest != same or any(node.name.startswith(f'/{space}/') for node in recording.nodes):
            continue
        numbered = re.sub(r'\d+', '#', space)
        is_other = nearest_spelling(space, [known]) is None or ('#' in numbered and numbered == re.sub(r'\d+', '#', known))
        process = next((node.process for node in recording.nodes if node.name == one.node), None)
        argv = next((each.argv for each in recording.processes if each.name == process), ())
        if is_other and any(f':={one.name}' in word for word in argv):
            return True
    return False


def _commands(recording: Recording) -> set[str]:
    """Return the nodes with remappings from launch files and the nodes of `ros2 topic` commands. A student typed their topics."""
    typed = {process.name for process in recording.processes if '-r' in process.argv or process.argv[1:2] == ['topic']}
    return {node.name for node in recording.nodes if node.process in typed}


@rule(
    'messages.nobody-listens',
    what='{node} sends commands on {topic}, but no node subscribes to it',
    why='a message on a topic without a subscription is lost',
    do=(
        'set the variable in this name: its value is {empty}, which becomes the word {empty} in a string',
        'remove the remapping of {topic} to {moved} from {mover}, or add the same remapping to {node}',
        'publish on {near}, which has a subscription',
        'start the node that subscribes to {topic}, or look up the right name with `ros2 topic list -t`',
    ),
    lesson=LESSON,
    level='error',
)
def nobody_listens(recording: Recording) -> Iterator[Finding]:
    """Report a topic for velocities that has no subscription. Other topics often have no subscription."""
    ends = ends_by_name(recording)
    subscribed = [name for kind, name in ends if kind == 'subscription']
    for end in lone_ends(recording, 'publisher'):
        if end.type in COMMANDS and _sent(recording, end):
            file, line = end_place(recording, end.kind, end.name, end.node)
            senders = {name: [one.node for one in ends.get(('publisher', name), ())] for name in subscribed}
            listening = [
                name for name in subscribed if ends['subscription', name][0].type == end.type and end.node not in senders[name]
            ]
            listening = [name for name in listening if not senders[name]] or listening
            near = nearest(end.name, listening) if len(listening) > 1 else next(iter(listening), None)
            mover, moved = _moved(recording, end.name)
            facts = {'node': speaker(recording, end.node), 'near': near, 'empty': _empty_part(end.name)}
            yield found('topic', end.name, file=file, line=line, time_s=end.made_s, **facts, mover=mover, moved=moved)


def _empty_part(name: str) -> str | None:
    """Return 'None' if a part of the name is the string 'None', because a program used a variable without a value."""
    return 'None' if 'None' in name.split('/') else None


COMMANDS = ('geometry_msgs/msg/Twist', 'geometry_msgs/msg/TwistStamped')


@rule(
    'messages.nobody-publishes',
    what='{node} subscribes to {topic}, but no node publishes on this topic',
    why='ROS 2 never calls the callback of this subscription',
    do=(
        'set the variable in this name: its value is {empty}, which becomes the word {empty} in a string',
        'subscribe to {near} if you mean that topic',
        'start the node that publishes on {topic}, or look up the right name with `ros2 topic list -t`',
    ),
    lesson=LESSON,
    confidence='asked',
)
def nobody_publishes(recording: Recording) -> Iterator[Finding]:
    """Report a subscription of a student's node that existed for a second without a publisher."""
    sent = [name for kind, name in ends_by_name(recording) if kind == 'publisher' and not is_ros_own(name)]
    own = own_nodes(recording)
    for end in lone_ends(recording, 'subscription'):
        if end.node in own and recording.duration_s - end.made_s >= 1.0 and end.type not in COMMANDS:
            file, line = end_place(recording, end.kind, end.name, end.node)
            ends = {name: ends_by_name(recording)['publisher', name] for name in sent}
            fitting = [name for name in sent if ends[name][0].type == end.type and ends[name][0].node != end.node]
            facts = {
                'node': speaker(recording, end.node),
                'near': nearest_spelling(end.name, fitting),
                'empty': _empty_part(end.name),
            }
            yield found('topic', end.name, file=file, line=line, time_s=end.made_s, **facts)


@rule(
    'messages.too-early',
    what='{node} published on {topic} only before {other} subscribed, so the messages are lost',
    why='a publisher does not store its messages for later subscriptions',
    do=(
        'publish again later, for example from a timer, or use QoSProfile(depth=1, '
        'durability=DurabilityPolicy.TRANSIENT_LOCAL) on both sides'
    ),
    lesson=LESSON,
)
def too_early(recording: Recording) -> Iterator[Finding]:
    """Report a topic whose last message was sent before its first subscription existed.

    Skip a publisher and a subscription that are both transient local. If publisher and subscription were created at the same
    time, the program that started first counts as earlier.
    """
    last: dict[str, float] = {}
    for row in recording.rows('topics'):
        if row['times']:
            last[row['topic']] = max(last.get(row['topic'], 0.0), row['times'][-1] / 1e9)
    order = {id(end): number for number, end in enumerate(recording.ends)}
    for (kind, topic), subscriptions in ends_by_name(recording).items():
        publishers = ends_by_name(recording).get(('publisher', topic))
        if kind != 'subscription' or topic not in last or publishers is None or is_ros_own(topic):
            continue
        first = subscriptions[0]
        is_latched = first.qos[2] == 'transient_local' and any(end.qos[2] == 'transient_local' for end in publishers)
        at_once = (
            first.made_s == last[topic]
            and order[id(first)] > order[id(publishers[-1])]
            and _is_in_other_program(recording, first, publishers)
        )
        if (first.made_s > last[topic] or at_once) and not is_latched:
            file, line = end_place(recording, 'publisher', topic, publishers[0].node)
            pair = {'node': speaker(recording, publishers[0].node), 'other': speaker(recording, first.node)}
            yield found('topic', topic, file=file, line=line, time_s=last[topic], **pair)


def _is_in_other_program(recording: Recording, end: EndRecord, others: list[EndRecord]) -> bool:
    """Return whether the program of an endpoint is different from the programs of all other endpoints."""
    return all(programs(recording).get(other.node) != programs(recording).get(end.node) for other in others)


TURNS = 5
CLOSE_NS = 1_000_000_000


@rule(
    'messages.two-commanders',
    what='{first} and {second} send different commands on {topic} ({turns} changes within one second)',
    why='the robot follows the latest command, so it alternates between the two commands',
    do='let only one node send commands at a time: stop one of them, or use a separate robot for each',
    lesson='10_carrots',
)
def two_commanders(recording: Recording) -> Iterator[Finding]:
    """Report two nodes that send different velocities to one topic within a second of each other, at least five times."""
    for (kind, topic), publishers in ends_by_name(recording).items():
        nodes = {end.node for end in publishers}
        if kind != 'publisher' or publishers[0].type not in COMMANDS or len(nodes) < 2:
            continue
        turns, first_s, pair = _quarrels(recording.published(topic, publishers[0].type))
        if turns >= TURNS:
            file, line = end_place(recording, 'publisher', topic, pair[1])
            yield found('topic', topic, file=file, line=line, time_s=first_s, first=pair[0], second=pair[1], turns=turns)


def _quarrels(rows: list[tuple[int, str, object]]) -> tuple[int, float, tuple[str, str]]:
    """Return how often a node sends another velocity within a second after a different node.

    Also return the time of the first case in seconds, and the two nodes.
    """
    turns, first_s, pair = 0, 0.0, ('', '')
    for (before_ns, node, wire), (time_ns, other, new) in zip(rows, rows[1:], strict=False):
        if node != other and wire != new and time_ns - before_ns < CLOSE_NS:
            turns += 1
            if turns == 1:
                first_s, pair = time_ns / 1e9, (node, other)
    return turns, first_s, pair

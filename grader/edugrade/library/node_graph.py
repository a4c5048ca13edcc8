"""Checks of nodes and topics: which nodes exist, which nodes publish, and which nodes subscribe."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..evidence import Advice, Evidence, Failure, Mismatch, Missing
from .identity import STARTERS, nodes_of, process_of
from .launched import refuse_strangers

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, TopicRecord

ALWAYS_THERE = ('/rosout', '/parameter_events', '/tf', '/tf_static')


Found = tuple[int, 'NodeRecord']
OF_A_TOOL = '_ros2cli'  # prefix of the nodes of command line tools, which ROS 2 hides


def named_nodes(recording: Recording, name: str, package: str | None = None, executable: str | None = None) -> list[Found]:
    """Return (position in the recording, node) for each node with a fully qualified name.

    If `package` is given, include only the nodes of its programs. If `executable` is given, too, include only the nodes of
    this program.
    """
    own = None if package is None else set(nodes_of(recording, package, executable))
    found = [(position, node) for position, node in enumerate(recording.nodes) if node.name == name]
    return [item for item in found if own is None or item[0] in own]


def require_node(run: Evidence, name: str, package: str | None, try_: Advice, executable: str | None = None) -> dict[str, Found]:
    """Return (position, node) for the first node with this fully qualified name and program, by scenario.

    :param package: the package of the program, or None for any program.
    :param executable: the program of that package, or None for any of its programs.
    :raises Missing: with the names of the existing nodes. For a node of another program, the error names its process.
    """
    found: dict[str, Found] = {}
    for scenario, recording in run.items():
        nodes = named_nodes(recording, name, package, executable)
        if not nodes:
            others = [f'{node.name} of another program ({node.process})' for _, node in named_nodes(recording, name)]
            own = range(len(recording.nodes)) if package is None else nodes_of(recording, package)
            among = [] if others else [recording.nodes[position].name for position in own]
            program = f' of {" ".join(filter(None, (package, executable)))}' if package and others else ''
            raise Missing(
                f'the node {name}{program}',
                name=_to_correct(run, scenario, name, among),
                among=among,
                expected=name if among or others else None,
                seen=', '.join(others) or None,
                where=run.source.place,
                try_=try_,
            )
        found[scenario] = nodes[0]
    return found


def _to_correct(run: Evidence, scenario: str, name: str, among: Sequence[str]) -> str | None:
    """Return the name if it can be a correction of one of the other names, or None.

    The value of a launch argument is not a correction of a fixed name, because a launch file cannot contain it. Neither is a
    name a correction of the name of a program, because the launch file does not contain that name of the node.
    """
    from edulaunch.engine.nearest import nearest

    values = {str(value) for value in run.scenario(scenario).arguments.values()} & set(name.split('/'))
    programs = {process.executable for process in run[scenario].processes} - {name.rpartition('/')[2]}
    if (nearest(name, among) or '').rpartition('/')[2] in programs:
        return None
    return name if any(values <= set(other.split('/')) for other in among) else None


def require_nodes(
    run: Evidence, scenario: str, names: Sequence[str], try_: Advice = None, packages: Mapping[str, str] | None = None
) -> None:
    """Require that exactly these nodes run. The nodes of `ros2` commands do not count.

    :param packages: the packages of some nodes, by the node's name, such as 'turtlesim' or, for one of its programs, 'turtlesim
        mimic'. The other nodes may belong to any program.
    :raises Failure: with both lists of nodes.
    :raises Missing: if a node belongs to another program.
    """
    recording = run[scenario]
    found = sorted(node.name for position, node in enumerate(recording.nodes) if not _is_of_a_tool(recording, position))
    if found != sorted(names):
        pairs = (found, names), (names, found)
        extra, lacking = (sorted((Counter(one) - Counter(other)).elements()) for one, other in pairs)
        words = [f'{", ".join(lacking)} should run'] * bool(lacking) + [f'{", ".join(extra)} should not run'] * bool(extra)
        raise Failure(
            f'{", and ".join(words)} in the run with {run.scenario(scenario).words}',
            expected=', '.join(sorted(names)),
            seen=', '.join(found) or 'none',
            where=run.source.place,
            try_=try_ or _correction(extra, lacking, run.scenario(scenario).words),
            name=lacking[0] if len(lacking) == 1 else None,
            among=extra,
        )
    for name, program in (packages or {}).items():
        if name in names:
            package, _, executable = program.partition(' ')
            require_node(run.only([scenario]), name, package, try_, executable or None)


def _correction(extra: Sequence[str], lacking: Sequence[str], words: str) -> str:
    """Return advice to start, rename or remove one of the wrong nodes of a run."""
    if extra and lacking:
        return f'give {extra[0]} the name {lacking[0]}: check its name and its namespace'
    if extra:
        return f'check the condition of {extra[0]}, which should not start with {words}'
    return f'start {lacking[0]} with {words}: add its Node, or check its condition and its event'


def _is_of_a_tool(recording: Recording, position: int) -> bool:
    """Return whether a hidden node belongs to a `ros2` command. A student's node with such a name does not."""
    node = recording.nodes[position]
    process = process_of(recording, node, position)
    if process is None or not node.name.rpartition('/')[2].startswith(OF_A_TOOL):
        return False
    first, *others = (word.rpartition('/')[2] for word in ' '.join(process.argv).split())
    return first == 'ros2' or (first in STARTERS and 'ros2' in others)


def require_listener(
    run: Evidence,
    scenario: str,
    node: str,
    topic: str,
    try_: Advice = None,
    package: str | None = None,
    executable: str | None = None,
) -> None:
    """Require messages on a topic, and a node with this name that subscribes to it.

    :param package: the package of the node's program, or None for any program.
    :param executable: the program of that package, or None for any of its programs.
    :raises Failure: with the names of the subscribers.
    """
    found = require_topic(run, scenario, topic, try_=try_)
    nodes = named_nodes(run[scenario], node, package, executable)
    if not any(name == topic for _, each in nodes for name, _ in each.subscriptions):
        seen = f'subscribers of {topic}: {", ".join(found.subscriptions) or "none"}'
        if node in found.subscriptions:
            seen += f'\nthis {node} is not a program of {package}'
        heard = heard_topics(nodes[0][1]) if nodes else []
        if heard:
            seen = f'{node} subscribes to {", ".join(heard)}'
        process = process_of(run[scenario], nodes[0][1], nodes[0][0]) if nodes else None
        raise Failure(
            f'{node} does not subscribe to {topic}',
            expected=f'a subscription of {node} to {topic}',
            seen=seen,
            where=run.source.own(process.origin if process else None),
            try_=try_,
            name=topic,
            among=heard,
        )
    refuse_incompatible(run, scenario, node, {each.name for _, each in nodes}, topic, try_)


def refuse_incompatible(run: Evidence, scenario: str, words: str, names: set[str], topic: str, try_: Advice) -> None:
    """Refuse a subscription that receives nothing, because it is incompatible with each publisher of the topic.

    :param words: the subscribing node or program, for the message.
    :param names: the full names of the subscribing nodes.
    :raises Failure: with the policy that is incompatible.
    """
    recording = run[scenario]
    refused = [each for each in recording.mismatches if each.topic == topic and each.subscriber in names]
    publishers = set(recording.topics[topic].publishers) if topic in recording.topics else set()
    if refused and publishers <= {each.publisher for each in refused}:
        raise Failure(
            f'{words} receives no messages on {topic} in the run with {run.scenario(scenario).words}',
            expected='a subscription that is compatible with its publisher',
            seen=f'the subscription of {refused[0].subscriber} is incompatible with {refused[0].publisher}: {refused[0].why}',
            where=run.source.place,
            try_=try_,
        )


def heard_topics(node: NodeRecord) -> list[str]:
    """Return the topics to which the program of a node subscribes. The topics of every node are left out."""
    return [name for name, _ in node.subscriptions if name not in ALWAYS_THERE]


def own_name_of_topic(recording: Recording, position: int, node: NodeRecord, wanted: str = '') -> str:
    """Return the name that a program uses for the only topic to which it subscribes, or '...'.

    :param position: the position of the node in `recording.nodes`.
    :param wanted: the topic to which the node should subscribe. A remapping of this name is not the one that the program needs.
    """
    heard, process = heard_topics(node), process_of(recording, node, position)
    if len(heard) != 1:
        return '...'
    namespace = node.name.rpartition('/')[0]
    rules = [word.partition(':=') for word in process.argv] if process is not None else []
    used = (name for name, _, to in rules if to and heard[0] in (to, f'{namespace}/{to}'))
    inside = next((name for name in used if wanted not in (name, f'{namespace}/{name}')), heard[0])
    return inside.removeprefix(f'{namespace}/')


def require_started(
    run: Evidence, scenario: str, node: str, try_: Advice = None, package: str | None = None, executable: str | None = None
) -> float:
    """Return the time at which a node started, in simulated seconds.

    :raises Missing: if the node never started, with the names of the existing nodes.
    """
    return require_node(run.only([scenario]), node, package, try_, executable)[scenario][1].started_s


def require_ended(
    run: Evidence, scenario: str, node: str, try_: Advice = None, package: str | None = None, executable: str | None = None
) -> float:
    """Return the time at which a node ended before the end of the run, in simulated seconds.

    :raises Missing: if the node never started, with the names of the existing nodes.
    :raises Failure: if the node ran until the end of the run.
    """
    ended_s = require_node(run.only([scenario]), node, package, try_, executable)[scenario][1].ended_s
    recording = run[scenario]
    if ended_s is None:
        raise Failure(
            f'{node} does not end in the run with {run.scenario(scenario).words}',
            expected=f'{node} ends before the end of the run',
            seen=f'{node} still runs after {recording.duration_s:.1f} s',
            where=run.source.place,
            try_=try_,
        )
    return ended_s


def require_topic(
    run: Evidence, scenario: str, name: str, type_: str | None = None, package: str | None = None, try_: Advice = None
) -> TopicRecord:
    """Require messages on a topic, and return the topic. The message that the grader sends (`Scenario.sent`) does not count.

    :param type_: the message type of the topic, or None for any type.
    :param package: the only package whose programs may publish the topic, or None for any package.
    :raises Missing: if the topic does not exist, with the nearest name.
    :raises Mismatch: if the topic has another type.
    :raises Failure: if the topic has no messages, or another program publishes it.
    """
    topics = run[scenario].topics
    found = topics.get(name)
    own = 0 if found is None else found.count - (name in run.scenario(scenario).sent)
    if found is None or own <= 0:
        among = [topic.name for topic in topics.values() if topic.count and topic.name != name]
        if found is not None:
            listeners, speakers = (', '.join(names) or 'none' for names in (found.subscriptions, found.publishers))
            raise Failure(
                f'no message was published on {name}',
                expected=f'a node that publishes messages on {name}',
                seen=f'publishers: {speakers}; subscribers: {listeners}',
                where=run.source.place,
                try_=try_,
            )
        raise Missing(
            f'the topic {name}',
            name=_to_correct(run, scenario, name, among),
            among=among,
            expected=name if among else None,
            where=run.source.place,
            try_=try_,
        )
    if type_ is not None and found.type != type_:
        raise Mismatch(f'the type of {name}', type_, found.type, where=run.source.place, try_=try_)
    if package is not None:
        refuse_strangers(run[scenario], name, package)
    return found


def loose_ends(recording: Recording, package: str, executable: str) -> list[str]:
    """Return sentences about the topics of an executable's nodes that have no publisher or no subscriber."""
    words: list[str] = []
    for position in nodes_of(recording, package, executable):
        words += _loose(recording.nodes[position], recording)
    return words


def _loose(node: NodeRecord, recording: Recording) -> list[str]:
    words = []
    for topic, _ in node.publishers:
        if topic not in ALWAYS_THERE and not recording.topics[topic].subscriptions:
            words.append(f'{node.name} publishes on {topic}, which has no subscriber')
    for topic, _ in node.subscriptions:
        if topic not in ALWAYS_THERE and not recording.topics[topic].publishers:
            words.append(f'{node.name} subscribes to {topic}, which has no publisher')
    return words

"""Who publishes and who listens: what a rubric says about nodes and topics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..evidence import Evidence, Failure, Mismatch, Missing
from .launched import find_processes, is_of, refuse_strangers

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, TopicRecord

ALWAYS_THERE = ('/rosout', '/parameter_events', '/tf', '/tf_static')


def require_node(run: Evidence, name: str, package: str, try_: str) -> None:
    """Every run has a node of this fully qualified name, of a program of this package.

    :raises Missing: naming the nodes of the package that are there.
    """
    for recording in run.values():
        names = [node.name for node in recording.nodes if is_of(recording, node.process, package)]
        if name not in names:
            raise Missing(f'the node {name}', name=name, among=names, where=run.source.place, try_=try_)


def require_nodes(run: Evidence, scenario: str, names: Sequence[str], try_: str | None = None) -> None:
    """Exactly these nodes run; those of the command line's tools do not count.

    :raises Mismatch: naming both.
    """
    found = sorted(node.name for node in run[scenario].nodes if not node.name.rpartition('/')[2].startswith('_'))
    if found != sorted(names):
        seen = ', '.join(found) or 'none'
        words = run.scenario(scenario).words
        raise Mismatch(
            f'the nodes, when launched with {words}', ', '.join(sorted(names)), seen, where=run.source.place, try_=try_
        )


def require_listener(run: Evidence, scenario: str, node: str, topic: str, try_: str | None = None) -> None:
    """Messages come on a topic, and a node of this name listens there.

    :raises Missing: naming who listens.
    """
    found = require_topic(run, scenario, topic, try_=try_)
    if node not in found.subscriptions:
        seen = f'listened to by {", ".join(found.subscriptions) or "nobody"}'
        raise Missing(f'{node} among those who listen to {topic}', seen=seen, where=run.source.place, try_=try_)


def require_started(run: Evidence, scenario: str, node: str, try_: str | None = None) -> float:
    """When a node started, in simulated seconds.

    :raises Missing: naming the nodes that are there.
    """
    started = {each.name: each.started_s for each in run[scenario].nodes}
    if node not in started:
        raise Missing(f'the node {node}', name=node, among=list(started), where=run.source.place, try_=try_)
    return started[node]


def require_ended(run: Evidence, scenario: str, node: str, try_: str | None = None) -> float:
    """When a node ended before the run was over, in simulated seconds.

    :raises Missing: when it never started, naming the nodes that are there.
    :raises Failure: when it ran until the run was over.
    """
    require_started(run, scenario, node, try_)
    recording = run[scenario]
    ended_s = next(each.ended_s for each in recording.nodes if each.name == node)
    if ended_s is None:
        raise Failure(
            f'{node} does not end, when launched with {run.scenario(scenario).words}',
            expected='it ends before the run is over',
            seen=f'it still runs after {recording.duration_s:.1f} s',
            where=run.source.place,
            try_=try_,
        )
    return ended_s


def require_topic(
    run: Evidence, scenario: str, name: str, type_: str | None = None, package: str | None = None, try_: str | None = None
) -> TopicRecord:
    """Messages come on a topic: of this type, and from nobody but programs of this package, where these are given.

    :raises Missing: naming the nearest topic; or when nothing was published.
    :raises Mismatch: for another type.
    :raises Failure: when somebody else publishes it.
    """
    topics = run[scenario].topics
    found = topics.get(name)
    if found is None or not found.count:
        among = [topic.name for topic in topics.values() if topic.count]
        if found is not None:
            listeners, speakers = (', '.join(names) or 'nobody' for names in (found.subscriptions, found.publishers))
            seen = f'listened to by {listeners}, published by {speakers}'
            raise Missing(f'a message on {name}', seen=seen, where=run.source.place, try_=try_)
        raise Missing(f'the topic {name}', name=name, among=among, where=run.source.place, try_=try_)
    if type_ is not None and found.type != type_:
        raise Mismatch(f'the type of {name}', type_, found.type, where=run.source.place, try_=try_)
    if package is not None:
        refuse_strangers(run[scenario], name, package)
    return found


def loose_ends(recording: Recording, package: str, executable: str) -> list[str]:
    """In words: topics on which the nodes of an executable talk to nobody, or listen to nobody."""
    launched = {process.name for process in find_processes(recording, package, executable)}
    words: list[str] = []
    for node in recording.nodes:
        if node.process in launched:
            words += _loose(node, recording)
    return words


def _loose(node: NodeRecord, recording: Recording) -> list[str]:
    words = []
    for topic, _ in node.publishers:
        if topic not in ALWAYS_THERE and not recording.topics[topic].subscriptions:
            words.append(f'{node.name} publishes {topic}, to which nobody listens')
    for topic, _ in node.subscriptions:
        if topic not in ALWAYS_THERE and not recording.topics[topic].publishers:
            words.append(f'{node.name} listens to {topic}, which nobody publishes')
    return words

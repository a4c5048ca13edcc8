"""Checks that a node receives the messages that another node publishes. The endpoints of both nodes and the logged lines show
this.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from ..evidence import Advice, Evidence, Failure, Mismatch
from .identity import nodes_of
from .node_graph import ALWAYS_THERE, named_nodes, refuse_incompatible, require_node

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord

HEARD_AFTER_S = 1.0  # largest time between a message and the line that a node logs about it


class Program(NamedTuple):
    """A description of nodes: the full name of a node, a package and executable, or both."""

    node: str = ''
    package: str | None = None
    executable: str | None = None

    @property
    def words(self) -> str:
        """The name of the node, or of the program, in words for a sentence."""
        return self.node or ' '.join(filter(None, (self.executable, self.package and f'of {self.package}')))

    def nodes(self, recording: Recording) -> list[NodeRecord]:
        """Return the nodes of a recording that fit this description, in order of creation."""
        if self.node:
            return [node for _, node in named_nodes(recording, self.node, self.package, self.executable)]
        return [recording.nodes[position] for position in nodes_of(recording, self.package or '', self.executable)]

    def names(self, recording: Recording) -> set[str]:
        """Return the full names of these nodes."""
        return {node.name for node in self.nodes(recording)}


def require_heard(run: Evidence, scenario: str, listener: Program, speaker: Program, try_: Advice) -> None:
    """Require that a node subscribes to a topic on which another node publishes messages, whatever the topic is called.

    :param listener: the node that must subscribe.
    :param speaker: the node that publishes.
    :raises Missing: if one of the nodes does not exist.
    :raises Failure: with the topics of both nodes.
    """
    recording = run[scenario]
    for each in (speaker, listener):
        if not each.nodes(recording) and each.node:
            require_node(run.only([scenario]), each.node, each.package, try_, each.executable)
    spoken = _topics(node.publishers for node in speaker.nodes(recording))
    heard = _topics(node.subscriptions for node in listener.nodes(recording))
    live = [name for name in spoken if (record := recording.topics.get(name)) is not None and record.count]
    for topic in (name for name in live if name in heard):
        refuse_incompatible(run, scenario, listener.words, listener.names(recording), topic, try_)
    if not set(live) & set(heard):
        raise Failure(
            f'{listener.words} receives no messages of {speaker.words} in the run with {run.scenario(scenario).words}',
            expected=f'{listener.words} subscribes to {" or ".join(live or spoken) or "a topic"}'
            + ('' if live else f', where {speaker.words} publishes messages'),
            seen=f'{listener.words} subscribes to {", ".join(heard) or "no topic"}',
            where=run.source.place,
            try_=try_,
        )


def require_lines_of_messages(
    run: Evidence, scenario: str, listener: Program, topic: str, lines: Sequence[tuple[float, str]], try_: Advice
) -> None:
    """Require that the lines of a node follow the messages that the node receives on a topic.

    The node must subscribe to the topic, and must never have logged more lines than messages have arrived. If the grader sends a
    message (`Scenario.sent`), a line soon afterwards must contain its string.

    :param lines: (simulated time in seconds, string) of each line.
    :raises Failure: if the node does not subscribe to the topic.
    :raises Mismatch: with the expected and the logged line.
    """
    recording = run[scenario]
    if topic not in _topics(node.subscriptions for node in listener.nodes(recording)):
        thing = f'{listener.words} does not subscribe to {topic}'
        raise Failure(thing, expected=f'a subscription of {listener.words} to {topic}', where=run.source.place, try_=try_)
    refuse_incompatible(run, scenario, listener.words, listener.names(recording), topic, try_)
    times = [time_s for time_s, _ in recording.messages(topic)] if topic in recording.topics else []
    for number, (time_s, text) in enumerate(lines, 1):
        if number > bisect_right(times, time_s):
            thing = f'the line that {listener.words} logs at {time_s:.2f} s'
            raise Mismatch(thing, 'one line for each message that has arrived', text, where=run.source.place, try_=try_)
    sent_s, word = run.scenario(scenario).sent.get(topic, (0.0, ''))
    if word and not any(sent_s <= time_s <= sent_s + HEARD_AFTER_S and word in text for time_s, text in lines):
        near = ', '.join(text for time_s, text in lines if sent_s <= time_s <= sent_s + HEARD_AFTER_S) or 'no line'
        raise Mismatch(
            f'the line of {listener.words} for the message of {sent_s:.2f} s', word, near, where=run.source.place, try_=try_
        )


def _topics(ends: Iterable[Sequence[tuple[str, str]]]) -> list[str]:
    return [name for name in dict.fromkeys(name for many in ends for name, _ in many) if name not in ALWAYS_THERE]

"""Several nodes that steer one robot."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.recordings.topics import COMMANDS
from edulaunch.advice.rule import rule
from edulaunch.advice.runs import ends_by_name, node_place

if TYPE_CHECKING:
    from edulaunch.recording import Recording

TURNS = 5
CLOSE_NS = 1_000_000_000


@rule(
    'messages.two-commanders',
    what='{first} and {second} both send commands on {topic}, and do not agree ({turns} times within a second)',
    why='the robot follows whoever spoke last, so it goes to and fro between the two',
    do='let one node at a time send commands: stop one of them, or give each a robot of its own',
    lesson='10_carrots',
)
def two_commanders(recording: Recording) -> Iterator[Finding]:
    """Velocities of two nodes that differ and follow each other within a second, five times and more."""
    for (kind, topic), publishers in ends_by_name(recording).items():
        nodes = {end.node for end in publishers}
        if kind != 'publisher' or publishers[0].type not in COMMANDS or len(nodes) < 2:
            continue
        turns, first_s, pair = _quarrels(recording.published(topic, publishers[0].type))
        if turns >= TURNS:
            file, line = node_place(recording, pair[1])
            yield found('topic', topic, file=file, line=line, time_s=first_s, first=pair[0], second=pair[1], turns=turns)


def _quarrels(rows: list[tuple[int, str, object]]) -> tuple[int, float, tuple[str, str]]:
    """How often another node says something else within a second, when first, and who."""
    turns, first_s, pair = 0, 0.0, ('', '')
    for (before_ns, node, wire), (time_ns, other, new) in zip(rows, rows[1:], strict=False):
        if node != other and wire != new and time_ns - before_ns < CLOSE_NS:
            turns += 1
            if turns == 1:
                first_s, pair = time_ns / 1e9, (node, other)
    return turns, first_s, pair

"""Endpoints of a topic that were not connected, because their types differ or their QoS policies are incompatible."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from edulaunch.engine.recording.records import NodeRecord, Note

_TEXT = re.compile(
    r'(?P<topic>\S+): (?P<publisher>\S+) \(.*?\) and (?P<subscriber>\S+) \(.*?\) cannot talk because of (?P<why>.+)'
)


class Mismatch(NamedTuple):
    """A publisher and a subscription that were not connected: the topic, the reason ('TYPE' or the policy), and the names of
    the nodes.
    """

    note: Note
    topic: str
    why: str
    publisher: str
    subscriber: str


def mismatches(records: Iterable[NodeRecord], notes: Iterable[Note]) -> Iterator[Mismatch]:
    """Yield the mismatches of a run in order of time.

    If a node subscribes with several types, it receives messages of each of these types, so this is not a mismatch.
    """
    nodes = {node.name: node for node in records}
    for note in notes:
        match = _TEXT.fullmatch(note.text) if note.kind == 'incompatible' else None
        if match is None or match['publisher'] not in nodes or match['subscriber'] not in nodes:
            continue
        sent = {kind for name, kind in nodes[match['publisher']].publishers if name == match['topic']}
        expected = {kind for name, kind in nodes[match['subscriber']].subscriptions if name == match['topic']}
        if match['why'] != 'TYPE' or not sent & expected:
            yield Mismatch(note, match['topic'], match['why'], match['publisher'], match['subscriber'])

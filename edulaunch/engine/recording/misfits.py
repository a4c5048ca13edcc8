"""Ends of a topic that could not be joined: they have different types, or their quality of service does not fit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording
    from edulaunch.engine.recording.records import Note

_TEXT = re.compile(
    r'(?P<topic>\S+): (?P<publisher>\S+) \(.*?\) and (?P<subscriber>\S+) \(.*?\) cannot talk because of (?P<why>.+)'
)


class Misfit(NamedTuple):
    """The recorder's note of such ends, with the topic, the reason ('TYPE' or the policy), and the names of the two nodes."""

    note: Note
    topic: str
    why: str
    publisher: str
    subscriber: str


def misfits(recording: Recording) -> Iterator[Misfit]:
    """In order of time. A node that subscribes with several types hears its publisher all the same: that is no misfit."""
    nodes = {node.name: node for node in recording.nodes}
    for note in recording.notes:
        match = _TEXT.fullmatch(note.text) if note.kind == 'incompatible' else None
        if match is None or match['publisher'] not in nodes or match['subscriber'] not in nodes:
            continue
        sent = {kind for name, kind in nodes[match['publisher']].publishers if name == match['topic']}
        heard = {kind for name, kind in nodes[match['subscriber']].subscriptions if name == match['topic']}
        if match['why'] != 'TYPE' or not sent & heard:
            yield Misfit(note, match['topic'], match['why'], match['publisher'], match['subscriber'])

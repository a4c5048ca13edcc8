"""Findings as marks of the live view: what on the picture it is about, and the sentences."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.advice.finding import Finding
from edulaunch.advice.reader import reader_here
from edulaunch.advice.wording import told

if TYPE_CHECKING:
    from edulaunch.recording import Recording

DRAWN = ('node', 'topic', 'frame')


class Mark(NamedTuple):
    """See `edulaunch.view.film.Mark`."""

    time_s: float
    subject: tuple[str, str]
    text: str
    rule: str


def marks(recording: Recording) -> list[Mark]:
    """A mark for each finding, the worst first; files are named without their folders, for pages are kept and given on."""
    nodes = {node.process: node.name for node in reversed(recording.nodes)}
    return [_mark(finding, nodes) for finding in recording.advice]


def _mark(finding: Finding, nodes: dict[str, str]) -> Mark:
    """What is about a program stands at its first node."""
    subject = (finding.kind, finding.name)
    if finding.kind not in DRAWN:
        node = nodes.get(finding.process or finding.name)
        subject = ('node', node) if node else ('', '')
    file = None if finding.file is None else os.path.basename(finding.file)
    words = told(finding._replace(file=file), reader_here())
    return Mark(finding.time_s or 0.0, subject, str(words), finding.rule)

"""The launch graph of a run, written so that other names and another order make no difference."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..cpu_limit import TooLong, cpu_limit

if TYPE_CHECKING:
    from edulaunch.recording import Recording

LONGEST_S = 2.0
MOST_LINES = 400
USUAL = ('/rosout', '/parameter_events')


def launch_graph(recording: Recording | None) -> list[str]:
    """One line for each program (with the parameters it was given) and for each connection (who tells whom what), sorted.

    Names of nodes and topics are left out: a copy with other names has the same graph. [] for what cannot be looked at.
    """
    if recording is None:
        return []
    try:
        with cpu_limit(LONGEST_S):
            return sorted(_programs(recording) + _connections(recording))[:MOST_LINES]
    except (TooLong, AttributeError, TypeError, ValueError, LookupError, RecursionError):  # a recording that was made to be odd
        return []


def _programs(recording: Recording) -> list[str]:
    return [
        f'starts {process.package}/{process.executable}' + ''.join(f' {name}' for name in sorted(process.parameter_origins))
        if process.package
        else f'runs {process.argv[0].split()[0] if process.argv else ""}'
        for process in recording.processes
        if process.name != 'launch'
    ]


def _connections(recording: Recording) -> list[str]:
    programs = {process.name: f'{process.package}/{process.executable}' for process in recording.processes}
    owner = {node.name: programs.get(node.process, '?') for node in recording.nodes}
    return [
        f'{owner.get(speaker, "?")} tells {owner.get(listener, "?")} {topic.type}'
        for topic in recording.topics.values()
        if topic.name not in USUAL and topic.count
        for speaker in topic.publishers
        for listener in topic.subscriptions
    ]

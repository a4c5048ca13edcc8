"""Two nodes of one name."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.recording import Recording


@rule(
    'programs.same-name',
    what='two nodes are called {node}: one of {first}, one of {second}',
    why='whoever asks {node} for a parameter or a service reaches only one of them, and you cannot say which',
    do="give one of them another name, for instance name='{other}' in the launch file, or another namespace",
    lesson='01_first_launch',
)
def same_name(recording: Recording) -> Iterator[Finding]:
    """Alive at the same time; a node that was started again after its end is no second one, nor are those of `ros2` commands."""
    origins = {process.name: process.origin for process in recording.processes}
    alive: dict[str, tuple[str, float | None]] = {}
    for node in recording.nodes:
        before = alive.get(node.name)
        if before is not None and '/_' not in node.name and (before[1] is None or before[1] > node.started_s):
            file, line = origins.get(node.process) or (None, None)
            other = f'{node.name.rpartition("/")[2]}_2'
            yield found(
                'node', node.name, file=file, line=line, time_s=node.started_s, first=before[0], second=node.process, other=other
            )
        alive[node.name] = (node.process, node.ended_s)

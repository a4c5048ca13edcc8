"""What a program declares by itself: it is started alone, for a moment of simulated time, and asked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from edulaunch.processes.spec import ProcessSpec
from edulaunch.session import Session

MOMENT_S = 0.5


def declared_parameters(package: str, executable: str, workspaces: Sequence[str]) -> dict[str, Any]:
    """Parameter -> default value of the first node of a program; empty when it does not come so far by itself."""
    with Session(workspaces=workspaces) as session:
        session.host.start(ProcessSpec(argv=('ros2', 'run', package, executable), name=executable))
        session.run(MOMENT_S)
        recording = session.recording()
        for node in recording.nodes:
            found = recording.parameters(node.name)
            if found:
                return {name: parameter.value for name, parameter in found.items()}
    return {}

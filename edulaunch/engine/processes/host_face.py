"""The part of a machine that its programs use, as a protocol. The class `Host` implements this protocol and starts the programs,
so `process` does not import `host`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from types import CodeType

    from edulaunch.engine.graph.graph import Graph
    from edulaunch.engine.graph.parameter_files import Entry
    from edulaunch.engine.graph.tracer import Tracer
    from edulaunch.engine.packages import Index
    from edulaunch.engine.processes.deferred_hints import DeferredHints
    from edulaunch.engine.processes.finding import Overlay
    from edulaunch.engine.processes.spec import ProcessSpec
    from edulaunch.engine.processes.watchdog import Watchdog
    from edulaunch.engine.sim.real_pace import RealPace
    from edulaunch.engine.sim.simulation import Simulation

OnOutput = Callable[[str, str], object]
"""Called with 'stdout' or 'stderr' and the text that a program writes."""
OnExit = Callable[[int], object]
"""Called once with the return code of a program."""
JoinNetwork = Callable[[Mapping[str, str], Sequence[str], Callable[[str], object]], Callable[[], object]]
"""Joins a real ROS 2 network; see `Host.join_network`."""


class HostFace(Protocol):
    """The part of a machine that its programs may use; `Host` documents each member."""

    is_real: bool
    sim: Simulation
    graph: Graph
    index: Index
    tracer: Tracer
    env: dict[str, str]
    processes: list[Any]
    real_programs: list[Any]
    pace: RealPace
    hints: DeferredHints
    watchdog: Watchdog | None
    compiled: dict[str, tuple[tuple[int, int], CodeType]]
    generated_files: dict[str, Any]
    goal_ids: set[bytes]
    join_network: JoinNetwork | None
    where_on_network: Callable[[], str | None]
    make_launch_observer: Callable[[Any], Any] | None
    lines_in_set_order: Callable[[bytes], Sequence[int]]

    @property
    def real_look(self) -> Any: ...

    def overlay(self, index: Index) -> Overlay: ...

    def parameter_entries(self, path: str) -> Sequence[Entry]: ...

    def next_pid(self) -> int: ...

    def stdin_for(self, spec: ProcessSpec) -> Any: ...

    def program_here(self) -> Any: ...

    def start(self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None) -> Any: ...

    def start_launched(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any: ...

    def start_command(self, spec: ProcessSpec, on_output: OnOutput, on_exit: OnExit) -> Any: ...

    def knows(self, spec: ProcessSpec) -> bool: ...

    def ended(self, process: Any) -> None: ...

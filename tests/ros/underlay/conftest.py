"""A stage for the built-in programs: host and graph, a hand to poke them with, a tape of what happened."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO
from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.interfaces import install
from edulaunch.engine.interfaces.importer import installed_registry
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.underlay_place import underlay_prefix
from edulaunch.runtime.fittings import hint_of

if installed_registry() is None:
    install()

MS = 1_000_000


class Tape(Tracer):
    """Keeps (milliseconds, ...) of logs, outputs and publications."""

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim
        self.logs: list[tuple[float, str]] = []
        self.outputs: list[tuple[float, str]] = []
        self.published: dict[str, list[tuple[float, Any]]] = {}

    def now_ms(self) -> float:
        return (self._sim.now_ns - self._sim.start_ns) / MS

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        self.logs.append((self.now_ms(), message))

    def output(self, process: Any, stream: str, text: str) -> None:
        self.outputs.append((self.now_ms(), text))

    def channel(self, publisher: Any) -> Any:
        messages = self.published.setdefault(publisher.topic_name, [])
        return lambda record: messages.append((self.now_ms(), publisher.cls.from_wire(record[2])))


class Stage:
    """Runs built-in programs; `publish`, `ask` and `messages` stand for the rest of the ROS graph."""

    def __init__(self) -> None:
        self.sim = Simulation(seed=3)
        self.tape = Tape(self.sim)
        self.graph = Graph(self.sim, self.tape)
        self.index = Index([], [])
        self._publishers: dict[str, Any] = {}
        self.host = Host(self.sim, self.graph, self.index, env={}, hint_of=hint_of)
        self._hand = self.graph.add_node(None, 'hand', '/')

    def start(self, package: str, executable: str, *arguments: str, stdin: str = '') -> Process:
        """Start a built-in program; `stdin` is what it can read."""
        path = f'{underlay_prefix()}/lib/{package}/{executable}'
        spec = ProcessSpec(argv=(path, *arguments), name=executable, package=package, executable=executable)
        process = self.host.start(spec)
        assert isinstance(process, Process)
        process.streams.stdin = StringIO(stdin)
        return process

    def until(self, ms: float) -> None:
        """Let the time be `ms` after the start."""
        self.sim.run(self.sim.start_ns + round(ms * MS))

    def publish(self, topic: str, message: Any) -> None:
        """Publish once, now."""
        if topic not in self._publishers:
            self._publishers[topic] = self.graph.create_publisher(self._hand, topic, type(message), QoS())
        self._publishers[topic].publish(type(message).to_wire(message))

    def ask(self, service: str, cls: Any, **fields: Any) -> list[Any]:
        """Send a request now; the reply will stand in the list that is returned."""
        replies: list[Any] = []

        def on_ready() -> None:
            replies.append(cls.Response.from_wire(client.take()[1]))

        client = self.graph.create_client(self._hand, service, cls, QoS(), on_ready)
        client.send(cls.Request.to_wire(cls.Request(**fields)))
        return replies

    def messages(self, topic: str) -> list[Any]:
        """What was published on `topic` so far."""
        return [message for _, message in self.tape.published.get(topic, [])]

    def texts(self) -> list[str]:
        """What was logged so far."""
        return [text for _, text in self.tape.logs]


@pytest.fixture
def stage() -> Stage:
    return Stage()


@pytest.fixture
def program(stage: Any) -> Callable[[Callable[[], object]], Any]:
    """Runs a function as a program of its own at the start of the simulation."""

    def start(body: Callable[[], object]) -> Any:
        process = Process(stage.host, ProcessSpec(argv=('program',), name='program'), 4242, ['program'], lambda _: body())
        process.lifecycle.task.start()
        return process

    return start

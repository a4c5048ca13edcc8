"""Programs as plain functions, run as processes of one simulation; what they say is kept as (milliseconds, program, what)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.tracer import Tracer
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.sync import sleep
from edulaunch.runtime.fittings import hint_of

Ros = Callable[..., list[Any]]
"""What the fixture `ros` is: a function to be run between init and the end of a program."""


class Notes(Tracer):
    """Keeps what a test may want to look at."""

    def __init__(self) -> None:
        self.parameters: list[tuple[str, str, Any, str]] = []
        self.logs: list[tuple[int, str, str]] = []
        self._known: dict[tuple[str, Any], dict[str, Any]] = {}

    def fact(self, process: Any, kind: str, key: Any, data: dict[str, Any]) -> None:
        self._known[kind, key] = data

    def fact_over(self, process: Any, kind: str, key: Any) -> None:
        self._known.pop((kind, key), None)

    @property
    def facts(self) -> list[tuple[str, dict[str, Any]]]:
        """Those that still hold."""
        return [(kind, data) for (kind, _), data in self._known.items()]

    def waits(self) -> list[tuple[str, dict[str, Any]]]:
        """The facts about waits that cannot end."""
        return [(kind, data) for kind, data in self.facts if 'sleep' not in kind]

    def parameter(self, node: Any, name: str, value: Any, origin: str) -> None:
        self.parameters.append((node.fully_qualified_name, name, value, origin))

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        self.logs.append((level, logger, message))


class World:
    """One simulation. `start(program)` makes a process of a function; `say(what)` inside it adds to `log`."""

    def __init__(self) -> None:
        self.sim = Simulation()
        self.tracer = Notes()
        self.graph = Graph(self.sim, self.tracer)
        self.host = Host(self.sim, self.graph, Index([], []), env={}, hint_of=hint_of)
        self.log: list[tuple[float, str, Any]] = []
        self.output: dict[str, str] = {}

    def say(self, what: Any) -> None:
        self.log.append(((self.sim.now_ns - self.sim.start_ns) / 1e6, current_process().name, what))

    def start(
        self,
        program: Callable[[], Any],
        *arguments: str,
        name: str = 'main',
        env: dict[str, str] | None = None,
        parameter_origins: dict[str, str] | None = None,
    ) -> Process:
        spec = ProcessSpec(argv=(name, *arguments), name=name, env=env or {}, parameter_origins=parameter_origins or {})

        def main(process: Process) -> Any:
            program()

        process = Process(self.host, spec, self.host.next_pid(), [name, *arguments], main)
        self.output[name] = ''

        def keep(stream: str, text: str) -> None:
            self.output[name] += text

        process.on_output = keep
        process.lifecycle.task.start()
        return process

    def run(self, seconds: float = 100.0) -> list[tuple[float, str, Any]]:
        """Let time pass and give back the log."""
        self.sim.run(until_ns=self.sim.now_ns + int(seconds * 1e9))
        return self.log

    def run_program(self, program: Callable[[], Any], *arguments: str, seconds: float = 100.0, **options: Any) -> list[Any]:
        """Run one program and give back what it said, without times."""
        process = self.start(program, *arguments, **options)
        self.run(seconds)
        if process.returncode:
            raise AssertionError(self.output['main'])
        return [what for _, _, what in self.log]


def raised(act: Callable[..., Any], *arguments: Any, **options: Any) -> str | None:
    """What a call raises, as the last line of a traceback has it; None when it returns."""
    try:
        act(*arguments, **options)
    except Exception as error:
        return f'{type(error).__name__}: {error}'
    return None


def results(node: Any, *values: Any) -> list[str]:
    """Set parameter p to each value; the reasons, '' for success."""
    from rclpy.parameter import Parameter

    return [node.set_parameters([Parameter('p', value=value)])[0].reason for value in values]


def everything_ready(world: World, name: str, topic: str) -> Any:
    """A node of which everything is ready after 0.1 s: service, client, guard condition, subscription, timer."""
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Empty

    node = Node(name)

    def serve(request: Any, response: Any) -> Any:
        world.say((name, 'service'))
        return response

    node.create_service(Empty, f'{topic}/service', serve)
    node.create_client(Empty, f'{topic}/service').call_async(Empty.Request())
    node.create_guard_condition(lambda: world.say((name, 'guard'))).trigger()
    node.create_subscription(String, topic, lambda _: world.say((name, 'subscription')), 10)
    node.create_publisher(String, topic, 10).publish(String())
    timer = node.create_timer(0.1, lambda: world.say((name, 'timer')))
    node.create_guard_condition(timer.cancel)
    sleep(0.1)
    return node


@pytest.fixture
def world() -> World:
    return World()


@pytest.fixture
def ros(world: World) -> Ros:
    """Run a function between rclpy.init() and the end of a program; gives what it said."""
    import rclpy

    def run(body: Callable[[], Any], *arguments: str) -> list[Any]:
        def program() -> None:
            rclpy.init()
            body()

        return world.run_program(program, *arguments)

    return run

"""A fresh simulation for each test, with programs that do what the test says."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from greenlet import getcurrent

from edulaunch.engine.processes import current_process
from edulaunch.engine.processes.deferred_hints import DeferredHints
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import AmbientTask


@pytest.fixture(autouse=True)
def fresh_simulation(monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """The ambient process of this test, whose simulation nobody has used before."""
    for name in ('ROS_LOG_DIR', 'ROS_HOME', 'OVERRIDE_LAUNCH_PROCESS_OUTPUT', 'OVERRIDE_LAUNCH_SCREEN_FORMAT'):
        monkeypatch.delenv(name, raising=False)
    here: Any = getcurrent()
    before = here.__dict__.pop('task', None)
    here.task = AmbientTask(Simulation())
    yield current_process()
    here.task = before if before is not None else AmbientTask(Simulation())


class FakeProgram:
    """A started program; the test's script decides what it does and when."""

    def __init__(self, host: FakeHost, spec: Any, on_output: Any, on_exit: Any) -> None:
        self.host, self.spec, self.pid, self.returncode = host, spec, host.next_pid(), None
        self._on_output, self._on_exit = on_output, on_exit
        self.on_signal: Callable[[int], object] = lambda signum: self.exit(-signum)

    def at(self, seconds: float, action: Callable[[], object]) -> None:
        """Do something `seconds` after now, if the program still runs."""
        sim = self.host.sim
        sim.schedule(sim.now_ns + round(seconds * 1e9), lambda: action() if self.returncode is None else None)

    def print(self, text: str, stream: str = 'stdout') -> None:
        """Write at once."""
        self._on_output(stream, text)

    def exit(self, code: int) -> None:
        """End at once."""
        self.returncode = code
        self._on_exit(code)

    def send_signal(self, signum: int) -> None:
        """What launch calls."""
        self.host.log.append((round(self.host.sim.elapsed_s, 3), signal.Signals(signum).name, self.spec.name))
        self.on_signal(signum)


class FakeHost:
    """Starts fake programs by the first word of the command line, and logs what it is asked to do."""

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.compiled: dict[str, Any] = {}
        self.lines_in_set_order = lambda source: ()
        self.hints = DeferredHints()
        self.make_launch_observer = None
        self.log: list[tuple[float, str, str]] = []
        self.specs: list[Any] = []
        self.scripts: dict[str, Callable[[FakeProgram], object]] = {}
        self._pid = 100

    def next_pid(self) -> int:
        self._pid += 1
        return self._pid

    def overlay(self, index: Any) -> Any:
        from edulaunch.engine.processes.finding import Overlay

        return Overlay(index)

    def start(self, spec: Any, on_output: Any = None, on_exit: Any = None) -> FakeProgram:
        if spec.argv[0] not in self.scripts:
            raise FileNotFoundError(2, 'No such file or directory', spec.argv[0])
        self.log.append((round(self.sim.elapsed_s, 3), 'start', spec.name))
        self.specs.append(spec)
        program = FakeProgram(self, spec, on_output, on_exit)
        self.scripts[spec.argv[0]](program)
        return program

    start_launched = start


@pytest.fixture
def host(fresh_simulation: Any) -> FakeHost:
    """`quick` ends after 1 s, `forever` on SIGINT, `stubborn` only on SIGKILL, `talker` prints at 1 s."""
    fake = FakeHost(fresh_simulation.sim)
    fresh_simulation.host = fake

    def talk(program: FakeProgram) -> None:
        program.at(1.0, lambda: program.print('one\ntwo\nrest'))
        program.at(2.0, lambda: program.exit(0))

    def resist(program: FakeProgram) -> None:
        program.on_signal = lambda signum: program.exit(-9) if signum == signal.SIGKILL else None

    fake.scripts = {
        'quick': lambda program: program.at(1.0, lambda: program.exit(0)),
        'failing': lambda program: program.at(1.0, lambda: program.exit(3)),
        'forever': lambda program: None,
        'stubborn': resist,
        'talker': talk,
    }
    return fake


@pytest.fixture
def launch_it(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, list[str]]]:
    """Launch entities; gives the return code and the lines on the screen but the first, always equal one."""
    from launch import LaunchDescription, LaunchService

    def run(*entities: Any, **kwargs: Any) -> tuple[int, list[str]]:
        service = LaunchService(**kwargs)
        service.include_launch_description(LaunchDescription(entities))
        code = service.run()
        first, *lines = capsys.readouterr().out.splitlines()
        assert first == '[INFO] [launch]: Default logging verbosity is set to INFO'
        return code, lines

    return run

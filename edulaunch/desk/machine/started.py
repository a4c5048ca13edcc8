"""`edulaunch.start`: a private machine with a live view that runs while other cells of a notebook run, or in a script.

Like `edulaunch.run`, it is deterministic, because the machine records manual actions with their simulated time. So it can
repeat the run up to any instant and continue from there.
"""

from __future__ import annotations

import asyncio
import shlex
import time
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import suppress
from types import TracebackType
from typing import TYPE_CHECKING, Any

from edulaunch.desk.machine.live import FORGET_EVERY_S, LiveMachine, finish, in_its_turn
from edulaunch.desk.machine.network import is_walls_time
from edulaunch.desk.view import TABS
from edulaunch.desk.view.viewer import Viewer
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.packages.discovery import folder_of, workspaces_of_command
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.loops import outer_loop_set_aside
from edulaunch.engine.sim.simulation import EPOCH_NS
from edulaunch.errors import MissingExtra, UnusableInput
from edulaunch.runtime.plugins import offered
from edulaunch.runtime.session import PathLike, Session

if TYPE_CHECKING:
    from edulaunch.desk.machine.desk_widget import DeskWidget
    from edulaunch.engine.recording import Recording


LONGEST_SLEEP_S = 0.02
KEPT_S = 600.0
COMMAND_S = 5.0
"""A command receives SIGINT after this many simulated seconds."""


class Machine(LiveMachine):
    """A simulated machine that runs in real time while an asyncio loop runs, as in a notebook. Otherwise, it runs only in `run`.

    In a `with` statement, the machine ends with the block. `await machine` runs the machine until its launches have ended.

    :ivar session: the session that the machine runs.
    :ivar time: how simulated time follows real time: `time.speed`, `time.paused`.
    """

    can_continue = True
    """True until the machine joins a real network, because messages from the network cannot be repeated."""

    def __init__(
        self, make: Callable[[int], Session], speed: float = 1.0, keep_s: float | None = None, *, step: bool = False
    ) -> None:
        super().__init__(keep_s)
        self.steps_launches = step
        self._make = make
        self._done: list[tuple[int, dict[str, Any]]] = []
        self._served: list[Any] = []
        self._start_ns = EPOCH_NS
        self._is_again = False
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[None] | None = None
        self._begin(speed)
        with suppress(RuntimeError):  # without a running loop, time passes in `run` only
            self._loop = asyncio.get_running_loop()
            self._task = self._loop.create_task(self._follow())

    def _begin(self, speed: float) -> None:
        with outer_loop_set_aside():
            self.use(self._make(self._start_ns), speed)
        self._hand = Viewer(self, lambda message: None)

    def __repr__(self) -> str:
        state = 'paused' if self.time.paused else f'speed {self.time.speed:g}'
        return f'<Machine at {self.session.sim.elapsed_s:.3f} s, {state}, {len(self.session.graph.nodes)} nodes>'

    async def _follow(self) -> None:
        """Make simulated time follow real time while the asyncio loop runs."""
        while True:
            wait_s = self._advance()
            self.show_pages()
            await asyncio.sleep(LONGEST_SLEEP_S if wait_s is None else min(max(wait_s, 0.001), LONGEST_SLEEP_S))

    def soon(self, action: Callable[[], object]) -> None:
        """Run a function on the machine's thread. Any thread may call this method."""
        if self._loop is None:
            action()
        else:
            self._loop.call_soon_threadsafe(action)

    def _advance(self) -> float | None:
        with in_its_turn():
            if self.network is not None:
                self.network.listen(0)
            return self.run_due()

    @property
    def is_on_network(self) -> bool | None:
        """Return the same as `LiveMachine.is_on_network`, or None if the machine runs without an asyncio loop."""
        return None if self._loop is None else super().is_on_network

    def join_network(self, joins: bool) -> str:
        """Join a real network, or leave it. Return a message. The settings come from the environment in which Python was
        started.

        Before joining, repeat the run up to this instant with another start time, so that simulated time agrees with real time.

        :param joins: whether to join; otherwise, leave.
        """
        if self._loop is None:
            return 'a machine can join a network only while an asyncio loop runs, as in a notebook'
        if joins and self.can_continue and not is_walls_time(self.session.sim.now_ns):
            elapsed_ns = self.session.sim.now_ns - self._start_ns
            self._start_ns = time.time_ns() - elapsed_ns
            self._reach(elapsed_ns)
            self.time.paused = False
        self.can_continue = False
        return super().join_network(joins)

    def run(self, duration_s: float) -> Recording:
        """Run the machine as fast as possible for a simulated time. Return the recording so far.

        The interrupt button (Ctrl-C) ends this call early and keeps the recording.

        :param duration_s: simulated seconds.
        """
        left_s = duration_s
        while left_s > 0:
            part_s = min(left_s, FORGET_EVERY_S)
            left_s -= part_s
            with outer_loop_set_aside():
                interrupted = self.session.run(part_s)
            self.forget()
            if interrupted:
                break
        self.time.go_on()
        return self.recording()

    def pause(self) -> None:
        """Pause simulated time."""
        self.time.paused = True

    def play(self, speed: float | None = None) -> None:
        """Resume simulated time.

        :param speed: simulated seconds per real second, or None to keep the current speed.
        """
        if speed is not None:
            self.time.speed = speed
        self.time.paused = False

    def step(self, what: str = 'tick') -> None:
        """Advance the machine by one step, then pause it.

        :param what: 'tick' (a step of turtlesim, 16 ms), 'message' (until the next message), or 'callback' (one callback).
        :raises UnusableInput: for another word.
        """
        if what not in ('tick', 'message', 'callback'):
            raise UnusableInput(f'unknown step {what!r}: use tick, message or callback')
        self.take({'op': 'step', 'what': what})

    def ros2(self, line: str, seconds: float = COMMAND_S) -> str:
        """Run a ROS 2 command to its end, and return its output: `machine.ros2('topic list')`.

        :param line: the words after `ros2`.
        :param seconds: the simulated time in seconds after which Ctrl-C is sent.
        :raises UnusableInput: when the command cannot be parsed.
        """
        try:
            words = shlex.split(line)
        except ValueError as error:
            raise UnusableInput(f'cannot read this command: {error}', help='add the missing quotation mark') from None
        printed: list[str] = []
        spec = ProcessSpec(argv=('ros2', *words), name='ros2')
        sim = self.session.sim
        with outer_loop_set_aside():
            process = self.session.host.start(spec, lambda stream, text: printed.append(text), lambda code: sim.stop())
            assert isinstance(process, Process)
            finish(self.session, process, seconds)
        self.time.go_on()
        return ''.join(printed)

    def view(self, tab: str = 'graph') -> DeskWidget:
        """Return the live view as a widget.

        :param tab: the tab to show beside the turtles, such as 'frames', 'graph' or 'plot'.
        :raises UnusableInput: when anywidget is not installed, or there is no such tab.
        """
        return desk_widget(self, tab)

    def foxglove(self, port: int = 0, origins: Sequence[str] = ()) -> Any:
        """Serve this machine to Foxglove and Lichtblick. Return the server, which has `address` and `close()`.

        :param port: a port of this computer, or 0 for any free port.
        :param origins: the origins of other pages that may connect, in addition to the pages of Foxglove.
        :raises UnusableInput: when the plug-in is not installed, no asyncio loop runs, or the port is in use.
        """
        self._served.append(offered('foxglove')(self, port, origins))
        return self._served[-1]

    def slider(self, node: str, name: str, limits: tuple[float, float] | None = None) -> Any:
        """Return a slider that sets a parameter as `ros2 param set` does: `machine.slider('/sim', 'background_r')`.

        :param node: the full name of the node.
        :param name: the name of the parameter.
        :param limits: the smallest and the largest value (default: the range that the node declares).
        :raises UnusableInput: when ipywidgets is not installed, there is no such node or parameter, or no range is known.
        """
        from edulaunch.desk.machine.sliders import slider

        return slider(self, self.take, node, name, limits)

    def take(self, words: dict[str, Any]) -> None:
        """Handle a request as if it came from a live view."""
        self.do_for(self._hand, words)

    def record_request(self, words: dict[str, Any]) -> None:
        """Record a request from a page with its simulated time, so that `continue_at` can repeat the request."""
        if not self._is_again:
            self._done.append((self.session.sim.now_ns - self._start_ns, dict(words)))

    def continue_at(self, time_s: float) -> None:
        """Repeat the run up to an instant, with the same seed and the same manual actions, and continue from there.

        Everything that happened after that instant is lost.

        :param time_s: simulated seconds since the start.
        """
        self._reach(round(time_s * 1e9))
        self.time.paused = True

    def _reach(self, until: int) -> None:
        old, speed = self.session, self.time.speed
        self._done = [(at, words) for at, words in self._done if at <= until]
        old.close()
        self._begin(speed)
        self.time.paused = True
        sim, self._is_again = self.session.sim, True
        try:
            with in_its_turn():
                for at, words in self._done:
                    sim.run(self._start_ns + at)
                    self._hand.take(words)
                sim.run(max(self._start_ns + until, sim.now_ns))
        finally:
            self._is_again = False

    def close(self) -> None:
        """End all programs on the machine."""
        if self._task is not None:
            self._task.cancel()
            self._task = None
        while self._served:
            self._served.pop().close()
        self.leave_network()
        if self.selector is not None:
            self.selector.close()
        with outer_loop_set_aside():
            self.session.close()

    def __enter__(self) -> Machine:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __await__(self) -> Generator[Any, None, Recording]:
        return self._ended().__await__()

    async def _ended(self) -> Recording:
        while not self.session.is_over:
            await asyncio.sleep(LONGEST_SLEEP_S)
        return self.recording()


def desk_widget(machine: LiveMachine, tab: str) -> DeskWidget:
    """Return the live view of a machine as a widget, as in `Machine.view`.

    :raises UnusableInput: when anywidget is not installed, or there is no such tab.
    """
    if tab not in TABS:
        raise UnusableInput(f'unknown tab {tab!r}', help=did_you_mean(tab, TABS) or f'choose one of {", ".join(TABS)}')
    try:
        from edulaunch.desk.machine.desk_widget import DeskWidget
    except ImportError:
        raise MissingExtra('the live view in a notebook', 'anywidget', 'notebook') from None
    return DeskWidget(machine, tab)


def start(
    path_or_package: PathLike | None = None,
    file: str | None = None,
    *,
    arguments: Mapping[str, object] | None = None,
    seed: int = 0,
    speed: float = 1.0,
    workspaces: Sequence[PathLike] | None = None,
    keep_s: float | None = KEPT_S,
    step: bool = False,
) -> Machine:
    """Start a machine and a launch file on it. Unlike :func:`edulaunch.run`, return immediately; the machine continues to run.

    :param path_or_package: the path of a launch file, or the name of a package. None launches nothing.
    :param file: the name of a launch file in the package.
    :param arguments: the launch arguments by name, as on the command line.
    :param seed: the seed of all random numbers.
    :param speed: simulated seconds per real second.
    :param workspaces: folders with the student's packages (default: the same as in `run`).
    :param keep_s: the simulated time in seconds after which old messages are dropped, so that a machine can run for hours. None
        keeps all messages. Nodes, parameters and the last messages of each topic are always kept.
    :param step: whether to stop before the first action of the launch file. Continue in the tab *Launch* of
        `machine.view('launch')`.
    :raises UnusableInput: when the file or package does not exist, or `speed` is not above 0 and up to 100.
    """
    if not 0 < speed <= 100:
        raise UnusableInput(f'speed must be a number above 0 and up to 100, not {speed!r}')
    texts = {name: str(value) for name, value in (arguments or {}).items()}
    folders = workspaces_of_command((), path_or_package or '.') if workspaces is None else workspaces

    def make(start_ns: int) -> Session:
        session = Session(seed=seed, workspaces=folders, start_ns=start_ns, near=folder_of(path_or_package or '.'))
        if path_or_package is not None:
            session.launch(path_or_package, file, texts)
        return session

    return Machine(make, speed, keep_s, step=step)

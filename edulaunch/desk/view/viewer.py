"""The machine's side of one live view: it sends the timeline, and handles the user's mouse and keyboard.

The page may send any data. The reply to an invalid request is an error message.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from edulaunch.desk.view import ViewedMachine
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.panes import COUNT, Pane, completions
from edulaunch.desk.view.replay import RecorderSource, timeline_of
from edulaunch.desk.view.timeline import Timeline, marks_of
from edulaunch.engine.processes.inputs import PipedInput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.runtime.session import typed_command

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.sim.pacing import RealTime

TICK_NS = 16_000_000
"""The duration of a step of turtlesim's window."""
LONGEST_STEP_NS = 10_000_000_000
FASTEST = 100.0
LONGEST_LINE = 4000
MOST_CHOICES = 60
TypedIn = tuple[str, Mapping[str, str]]
"""The current folder and the environment of a terminal."""
DRIVER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'driver.py')


class Viewer:
    """Sends the data of a machine to one page, and handles the requests of the page.

    :param machine: the machine that the page shows.
    :param say: a function that sends a message (plain data) to the page.
    :param typed_in: the folder and environment of the terminal that opened the page, or None. Commands of the page find the same
        files and packages as this terminal.
    """

    def __init__(self, machine: ViewedMachine, say: Callable[[dict[str, Any]], object], typed_in: TypedIn | None = None) -> None:
        self._machine = machine
        self._typed_in = typed_in
        self._say = say
        self._session = machine.session
        self._timeline = Timeline(RecorderSource(self._session.recorder))
        self._driver: PipedInput | None = None
        self._panes = [Pane(number, self._start_typed, say) for number in range(COUNT)]
        self._sent_state: dict[str, object] | None = None

    def show(self) -> None:
        """Send an update to the page: a timeline delta, and the state of the simulated time."""
        message: dict[str, Any] = {}
        if self._look():
            message['reset'] = True
        machine = self._machine
        state: dict[str, object] = {'running': not self._time.paused, 'speed': self._time.speed}
        state |= {'can_continue': machine.can_continue, 'network': machine.is_on_network}
        state |= {'steps_launches': machine.steps_launches}
        if state != self._sent_state:
            message['machine'] = self._sent_state = state
        self._say({**message, 'delta': self._timeline.delta()})

    def has_programs(self) -> bool:
        """Return whether a program that a terminal of the page has started still runs."""
        return self._machine.session is self._session and any(pane.has_programs() for pane in self._panes)

    @property
    def _time(self) -> RealTime:
        return self._machine.time

    def _look(self) -> bool:
        """Start over if the machine now runs another session. Return whether it does."""
        if self._machine.session is self._session:
            return False
        self._session = self._machine.session
        self._timeline = Timeline(RecorderSource(self._session.recorder))
        self._driver, self._sent_state = None, None
        self._panes = [Pane(number, self._start_typed, self._say) for number in range(COUNT)]
        return True

    def take(self, request: Any) -> None:
        """Handle a request of the page: a dictionary with `op` and the values for this operation."""
        op = request.get('op') if isinstance(request, dict) else None
        action = _ACTIONS.get(op) if isinstance(op, str) else None
        if action is None:
            self._say({'said': 'The machine does not know this request.'})
            return
        self._look()
        if op in ('drive', 'teleport', 'param', 'line', 'keys', 'interrupt', 'process'):
            self._machine.record_request(request)
        try:
            action(self, request)
        except (KeyError, TypeError, ValueError) as error:
            self._say({'said': f'{request["op"]}: {error}'})

    def _pause(self, request: dict[str, Any]) -> None:
        if request['op'] == 'play':
            for trace in self._session.traces:
                trace.stepper.go('go')
        self._time.paused = request['op'] == 'pause'

    def _speed(self, request: dict[str, Any]) -> None:
        speed = _number(request, 'speed')
        self._time.speed = min(speed, FASTEST) if speed > 0 else FASTEST

    def _step(self, request: dict[str, Any]) -> None:
        """Run a tick of turtlesim, run until the next message, or run one item of the agenda. Then pause the time."""
        self._time.paused = True
        sim, recorder = self._session.sim, self._session.recorder
        what = request.get('what', 'tick')
        if what == 'tick':
            sim.run(sim.now_ns + TICK_NS)
        elif what == 'callback':
            sim.step()
        elif what == 'message':
            before, latest = recorder.publication_count(), sim.now_ns + LONGEST_STEP_NS
            while recorder.publication_count() == before and (sim.next_time_ns() or latest) < latest:
                sim.step()
        else:
            raise ValueError(f'unknown step {what!r}: use tick, message or callback')
        self._time.go_on()

    def _continue(self, request: dict[str, Any]) -> None:
        if not self._machine.can_continue:
            raise ValueError('other terminals use this machine, so it cannot go back: use a private machine (edulaunch.start)')
        self._machine.continue_at(min(max(_number(request, 'time'), 0.0), self._session.sim.elapsed_s))

    def _launch(self, request: dict[str, Any]) -> None:
        """Run a launch until its next action or event, or until it reaches a line. Then pause the time."""
        trace = next((one for one in self._session.traces if one.pid == request['pid']), None)
        if trace is None or trace.is_over:
            raise ValueError('this launch has ended')
        way, place = request['way'], None
        if way == 'line':
            place = str(request['file']), int(_number(request, 'line'))
        elif way not in ('into', 'next', 'event'):
            raise ValueError('a launch can step to the next action, into an include, to the next event or to a line')
        self._time.paused = True
        trace.stepper.go(way, place)
        sim, latest = self._session.sim, self._session.sim.now_ns + LONGEST_STEP_NS
        while sim.step() and not sim.is_suspended and (sim.next_time_ns() or latest) < latest:
            pass
        self._time.go_on()
        if not sim.is_suspended:
            trace.stepper.go('go')
            missing = {'event': 'No event follows', 'line': 'The launch does not reach this line'}.get(way, 'No action follows')
            self._say({'said': f'{missing} within 10 s of simulated time.'})

    def _stops(self, request: dict[str, Any]) -> None:
        """Set whether new launches stop before their first action. With `again`, repeat this launch and stop there."""
        on = request['on'] is True
        again = on and request.get('again') is True
        if again and not self._machine.can_continue:
            raise ValueError('other terminals use this machine, so launch the file again in one of them')
        self._machine.steps_launches = self._session.steps_launches = on
        if again:
            self._machine.continue_at(0.0)

    def _process(self, request: dict[str, Any]) -> None:
        """Stop, kill or restart a process of a launch."""
        trace = next((one for one in self._session.traces if one.pid == request['pid']), None)
        if trace is None:
            raise ValueError('this launch has ended')
        number, signals = int(_number(request, 'number')), {'stop': signal.SIGINT, 'kill': signal.SIGKILL}
        what = request['what']
        if what == 'restart':
            self._say({'said': trace.restart(number)})
        else:
            self._say({'said': trace.signal(number, signals[what])})

    def _drive(self, request: dict[str, Any]) -> None:
        who = _name(request, 'turtle')
        if self._driver is None:
            self._driver = PipedInput()
            process = self._start(['python3', DRIVER], 'desk')
            process.streams.stdin = self._driver
        self._driver.feed(f'{who or "/"} {_number(request, "linear")} {_number(request, "angular")}\n')

    def _network(self, request: dict[str, Any]) -> None:
        """Join a real network, or leave it."""
        self._say({'said': self._machine.join_network(request['on'] is True)})

    def _teleport(self, request: dict[str, Any]) -> None:
        x, y, theta = (_number(request, name) for name in ('x', 'y', 'theta'))
        place = f'{{x: {x:.4f}, y: {y:.4f}, theta: {theta:.4f}}}'
        name = f'{_name(request, "turtle")}/teleport_absolute'
        self._start(['ros2', 'service', 'call', name, 'turtlesim/srv/TeleportAbsolute', place], 'ros2')
        self._step({'what': 'tick'})

    def _parameter(self, request: dict[str, Any]) -> None:
        value = str(request['value'])
        words_of_line = ['ros2', 'param', 'set', _name(request, 'node'), str(request['name']), '--', value]
        self._start(words_of_line, 'ros2', lambda stream, text: self._say({'said': text.strip()}))

    def _line(self, request: dict[str, Any]) -> None:
        """Handle a line that the user has typed in one of the page's terminals."""
        self._panes[_pane(request)].line(str(request['line'])[:LONGEST_LINE])

    def _keys(self, request: dict[str, Any]) -> None:
        """Handle keys that the user has pressed in one of the page's terminals, for a program that reads keys."""
        self._panes[_pane(request)].keys(str(request['keys'])[:LONGEST_LINE])

    def _complete(self, request: dict[str, Any]) -> None:
        """Handle the Tab key in one of the page's terminals: complete the unambiguous part of the line, and list the possible
        words.
        """
        line = str(request['line'])[:LONGEST_LINE]
        *before, typed = line.split(' ')
        if before[:1] != ['ros2']:
            return
        found = completions(self._session, before[1:], typed, self._index)
        sure = os.path.commonprefix(found) + (' ' if len(found) == 1 and not found[0].endswith(('=', '/')) else '')
        completed = line[: len(line) - len(typed)] + sure if found else line
        self._say({'completed': [completed, found[:MOST_CHOICES]], 'pane': _pane(request)})

    def _interrupt(self, request: dict[str, Any]) -> None:
        """Handle Ctrl-C in one of the page's terminals."""
        self._panes[_pane(request)].interrupt()

    def _export(self, request: dict[str, Any]) -> None:
        """Send an HTML page that replays the run so far without other files or a network. The user saves it as a file."""
        recording = self._machine.recording()
        name = os.path.basename(recording.launch.file or '').partition('.')[0] or 'machine'
        self._say({'export': recorded_page(timeline_of(recording), name), 'name': f'{name}.html'})

    def _advise(self, request: dict[str, Any]) -> None:
        """Check the run so far with the rules of advice, and send the number of problems."""
        marks = marks_of(self._machine.recording())
        self._timeline.mark(marks)
        self._say({'said': f'Problems found: {len(marks)}.' if marks else 'No problems found.'})

    def _defaults(self, request: dict[str, Any]) -> None:
        """Send the defaults of parameters whose values come from a launch file or a command line."""
        from edulaunch.desk.view.defaults import defaults_of

        recorder = self._session.recorder
        found = defaults_of(recorder.nodes, recorder.processes, recorder.parameters, self._session.index)
        self._say({'defaults': found})

    def _start(
        self,
        argv: list[str],
        name: str,
        on_output: Callable[[str, str], object] | None = None,
        on_exit: Callable[[int], object] | None = None,
    ) -> Process:
        spec = ProcessSpec(argv=tuple(argv), name=f'{name}-view', cwd=os.getcwd())
        process = self._session.host.start(spec, on_output, on_exit)
        assert isinstance(process, Process)
        return process

    def _start_typed(
        self, argv: list[str], name: str, on_output: Callable[[str, str], object], on_exit: Callable[[int], object]
    ) -> Process:
        """Start a command from one of the page's terminals. Return its process."""
        if self._typed_in is None:
            return self._start(argv, name, on_output, on_exit)
        spec, index = typed_command(argv, f'{name}-view', *self._typed_in, self._session.index)
        process = self._session.host.start(spec, on_output, on_exit, index=index)
        assert isinstance(process, Process)
        return process

    def _index(self) -> Index:
        """Return the index of the packages that the page's terminals find."""
        if self._typed_in is None:
            return self._session.index
        return typed_command(['ros2'], 'ros2', *self._typed_in, self._session.index)[1]

    def close(self) -> None:
        """End the programs of the closed page. The machine continues to run."""
        if self._session.sim.is_suspended:
            self._session.let_go()
            self._time.paused = False
        if self._driver is not None:
            self._driver.feed('', last=True)
        for pane in self._panes:
            pane.interrupt()


_ACTIONS: dict[str, Callable[[Viewer, dict[str, Any]], None]] = {
    'pause': Viewer._pause,
    'play': Viewer._pause,
    'speed': Viewer._speed,
    'step': Viewer._step,
    'launch': Viewer._launch,
    'stops': Viewer._stops,
    'process': Viewer._process,
    'continue': Viewer._continue,
    'drive': Viewer._drive,
    'teleport': Viewer._teleport,
    'param': Viewer._parameter,
    'line': Viewer._line,
    'keys': Viewer._keys,
    'complete': Viewer._complete,
    'interrupt': Viewer._interrupt,
    'advise': Viewer._advise,
    'export': Viewer._export,
    'defaults': Viewer._defaults,
    'network': Viewer._network,
}


def _number(request: dict[str, Any], name: str) -> float:
    """Return the number with this name in a request.

    :raises ValueError: when the value is not a number between -1e6 and 1e6.
    """
    value = request.get(name)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not -1e6 < value < 1e6:
        raise ValueError(f'{name} must be a number')
    return float(value)


def _pane(request: dict[str, Any]) -> int:
    """Return the number of the terminal that a request names.

    :raises ValueError: when there is no terminal with that number.
    """
    pane = request.get('pane', 0)
    if pane not in range(COUNT) or isinstance(pane, bool):
        raise ValueError(f'there are {COUNT} terminals')
    return int(pane)


def _name(request: dict[str, Any], name: str) -> str:
    """Return the ROS name with this key in a request. It may contain letters, digits, underscores and slashes.

    :raises ValueError: for another value.
    """
    value = request.get(name)
    if not isinstance(value, str) or len(value) > 255 or not all(letter.isalnum() or letter in '_/' for letter in value):
        raise ValueError(f'{name} must be a ROS name')
    return value

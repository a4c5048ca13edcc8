"""`edulaunch launch --step`: step through a launch in a terminal.

Launch stops before each action or event, and the command shows a prompt.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.recording.views import view

if TYPE_CHECKING:
    from edulaunch.runtime.session import Session

HELP = """\
  Enter, i   go to the next action, also into an include or a group
  n          go to the next action after this include or group
  e          go to the next event that launch processes
  l FILE:N   go to the next action that line N of FILE makes
  b, f       look at the previous action, or forward again; this undoes nothing
  c          show the launch configurations, namespace, remappings and environment here
  w          show the state of each action of the launch
  g          continue without stopping
  q          shut the launch down, as Ctrl-C does
"""
PROMPT = '(launch) '
FIRST = 'press Enter for the next action, or ? for all answers; after the last action, the launch runs until Ctrl-C'


class TerminalSteps:
    """Shows a prompt each time the launch stops.

    :ivar waited_s: the real time in seconds that the prompt has waited. Simulated time does not advance while it waits.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._trace: Any = None
        self.waited_s = 0.0
        self._is_first = True
        self._in, self._out = sys.stdin, sys.stdout  # at a prompt, launch's process has its own streams

    def clock(self) -> float:
        """Return the real time in seconds, without the time that the prompt has waited."""
        return time.monotonic() - self.waited_s

    def begin(self) -> None:
        """Make each new launch stop before its first action."""
        make = self._session.host.make_launch_observer
        assert make is not None

        def stepped(process: Any) -> Any:
            self._trace = make(process)
            self._trace.stepper.go('into')
            self._trace.on_stop = self._stop
            return self._trace

        self._session.host.make_launch_observer = stepped

    def _stop(self, step: Any) -> None:
        """Show prompts until the student's answer continues the launch.

        Launch makes this call while its own task runs, so simulated time does not advance.
        """
        began = time.monotonic()
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            self._ask(step)
        finally:
            signal.signal(signal.SIGINT, before)
            self.waited_s += time.monotonic() - began

    def _ask(self, here: Any) -> None:
        shown = here
        self._show(shown, here)
        if self._is_first:
            self._is_first = False
            self._say(FIRST)
        while True:
            word, _, rest = self._line().partition(' ')
            way = {'': 'into', 'i': 'into', 'n': 'next', 'e': 'event', 'g': 'go', 'q': 'go'}.get(word)
            if way is not None:
                if word == 'q':
                    self._session.interrupt()
                return self._trace.stepper.go(way)  # type: ignore[no-any-return]
            if word == 'l' and (place := _place(rest)) is not None:
                return self._trace.stepper.go('line', place)  # type: ignore[no-any-return]
            if word in ('b', 'f'):
                shown = self._beside(shown, here, -1 if word == 'b' else 1)
                self._show(shown, here)
            elif word == 'l':
                self._say('give a file and a line, such as: l demo.launch.py:12')
            else:
                if word not in _LOOKS:
                    self._say(f'{word} is no answer; the answers are:')
                _LOOKS.get(word, TerminalSteps._help)(self, shown)

    def _line(self) -> str:
        """Return the line that the student types. Return 'q' for Ctrl-C and 'g' at the end of the input."""
        self._out.write(PROMPT)
        self._out.flush()
        try:
            line = self._in.readline()
        except KeyboardInterrupt:
            self._say('')
            return 'q'
        if not line:
            self._say('')
            return 'g'
        return line.strip()

    def _say(self, text: str) -> None:
        self._out.write(f'{text}\n')
        self._out.flush()

    def _stops(self) -> list[Any]:
        """Return the actions and events that launch has reached, in order."""
        steps = [step for step in self._trace.steps if step.order and (step.origin is not None or step.is_event)]
        return sorted(steps, key=lambda step: step.order)

    def _beside(self, shown: Any, here: Any, way: int) -> Any:
        stops = self._stops()
        number = stops.index(shown) + way
        if 0 <= number < len(stops):
            return stops[number]
        self._say('this is the first action' if way < 0 else 'launch is here; press Enter to continue')
        return shown

    def _show(self, step: Any, here: Any) -> None:
        row = view('row_of_step')(step)
        seconds = 0.0 if row['time'] is None else row['time'] / 1e9
        sign = '->' if step is here else '  '
        self._say(f'{sign} {seconds:.3f} s  {_where(row)}{row["text"]}' + ('' if step is here else f'  [{row["state"]}]'))

    def _context(self, step: Any) -> None:
        """Show the launch configurations and the environment variables before a step."""
        configurations, environment = self._trace.context_before(step)
        for name, value in configurations.items():
            self._say(f'  {_NAMES.get(name, name)}: {_shown(value)}')
        for name, value in environment.items():
            self._say(f'  ${name}: {"(unset)" if value is None else value}')
        if not configurations and not environment:
            self._say('  no launch configuration is set')

    def _list(self, step: Any) -> None:
        """Show all known actions with their states."""
        for child in self._trace.outline.children:
            self._tell(child, step, 0)

    def _tell(self, one: Any, here: Any, depth: int) -> None:
        row = view('row_of_step')(one)
        is_shown = row.get('file') is not None or row['kind'] == 'include'
        if row['kind'] == 'event':
            return
        if is_shown:
            state = 'here' if one is here else row['state']
            self._say(f'  {state:9} {"  " * depth}{_where(row)}{row["text"]}')
        for child in one.children:
            self._tell(child, here, depth + is_shown)

    def _help(self, step: Any) -> None:
        self._say(HELP.rstrip('\n'))


_NAMES = {'ros_namespace': 'namespace', 'ros_remaps': 'remappings', 'global_params': 'parameters for all nodes'}
_LOOKS: dict[str, Callable[[TerminalSteps, Any], object]] = {
    'c': TerminalSteps._context,
    'w': TerminalSteps._list,
    '?': TerminalSteps._help,
}


def _where(row: dict[str, Any]) -> str:
    return f'{os.path.basename(row["file"])}:{row["line"]}  ' if row.get('file') else ''


def _shown(value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return ', '.join(' -> '.join(map(str, one)) if isinstance(one, (list, tuple)) else str(one) for one in value)
    return repr(value) if isinstance(value, str) else str(value)


def _place(text: str) -> tuple[str, int] | None:
    file, _, line = text.strip().rpartition(':')
    return (file, int(line)) if file and line.isdigit() else None

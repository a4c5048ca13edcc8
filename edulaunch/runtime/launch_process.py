"""`ros2 launch` as a process of the simulation, and the reports about its failures."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from edulaunch.engine.packages import Index
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording import Recorder
from edulaunch.engine.recording.records import UnreadArgument
from edulaunch.errors import LaunchFileError
from edulaunch.runtime.fittings import help_of

_STOPPED = {
    'KeyboardInterrupt': ('the launch file was interrupted', 'run it again'),
    'RunawayProgramError': (
        'the launch file never came to its end and was stopped',
        'look for a loop that does not end: a launch file only says what to start',
    ),
}


class Explanation(NamedTuple):
    """An error in the form that users read: ROS 2's message with the place in the student's file, the help, and the facts as
    data.
    """

    text: str
    help: str | None
    data: dict[str, Any]


class LaunchRun:
    """One `ros2 launch` in the simulation: the process, its arguments, and its outcome."""

    def __init__(
        self,
        host: Host,
        recorder: Recorder,
        path: str,
        arguments: dict[str, str],
        *,
        console: Callable[[str, str], object] | None,
        interactive: bool,
        debug: bool,
    ) -> None:
        self.path = path
        self.arguments = arguments
        self.interactive = interactive
        self.debug = debug
        words = ['ros2', 'launch', path, *(f'{name}:={value}' for name, value in arguments.items())]
        spec = ProcessSpec(argv=tuple(words), name='launch')
        self.process = Process(host, spec, host.next_pid(), words, self._main)
        self.process.on_output = console
        self._host = host
        self.recorder = recorder

    def start(self) -> None:
        """Start the process."""
        self._host.adopt(self.process)

    @property
    def is_over(self) -> bool:
        """Return whether launch has ended."""
        return self.process.returncode is not None

    def interrupt(self) -> None:
        """Send SIGINT to launch. In a terminal, also send it to every program that launch started."""
        self.process.send_signal(signal.SIGINT)
        if self.interactive:
            for process in self._host.processes:
                if process is not self.process:
                    process.send_signal(signal.SIGINT)
            for program in self._host.real_programs:
                program.send_signal(signal.SIGINT)

    def _main(self, process: Process) -> int:
        """Run `ros2 launch FILE name:=value ...`. Return the return code of launch."""
        from launch import LaunchDescription, LaunchService
        from launch.actions import IncludeLaunchDescription
        from launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource

        include = IncludeLaunchDescription(AnyLaunchDescriptionSource(self.path), launch_arguments=list(self.arguments.items()))
        service = LaunchService(argv=list(process.argv), noninteractive=not self.interactive, debug=self.debug)
        service.include_launch_description(LaunchDescription([include]))
        return int(service.run())

    @property
    def error(self) -> BaseException | None:
        """The first exception that launch caught, or None."""
        errors = self.process.state.get('launch.exceptions')
        return errors[0] if errors else None

    def raise_error(self) -> None:
        """Raise the error of the launch file, if there was an error.

        :raises LaunchFileError: when there was an error. It has ROS 2's message, the place and one line of help.
        """
        error = self.error
        if error is not None:
            explanation = explain(error, self.process.index)
            raise LaunchFileError(explanation.text, help=explanation.help) from error
        stopped = self.process.exception
        if stopped is not None and stopped['type'] in _STOPPED:
            place = stopped['place']
            what, help = _STOPPED[stopped['type']]
            raise LaunchFileError(what if place is None else f'{what}\n  at {place}', help=help)

    def describe(self, recorder: Recorder) -> None:
        """Pass the launch file and its arguments to the recorder."""
        recorder.launch = describe(self)


def explain(error: BaseException, index: Index) -> Explanation:
    """Return an exception from a launch file in the form that users read. The places in it are in the student's own files."""
    from launch._failure import failure_data

    data = failure_data(error, index)
    text, place = str(error) or type(error).__name__, data['place']
    return Explanation(text if place is None else f'{text}\n  at {place}', help_of(data), data)


def describe(launch: LaunchRun) -> dict[str, Any]:
    """Return the record of a launch for a recording."""
    state = launch.process.state
    declared = [_declared(argument) for argument in state.get('launch.declared', ())]
    explanation = None if (error := launch.error) is None else explain(error, launch.process.index)
    file, line = (explanation.data['place'] if explanation else None) or (None, None)
    unread = [list(one) for one in _unread_arguments(launch.process, launch.arguments)]
    return {
        'file': launch.path,
        'arguments': launch.arguments,
        'declared': declared,
        'includes': list(state.get('launch.includes', ())),
        'returncode': launch.process.returncode,
        'error': explanation.text if explanation else None,
        'error_file': file,
        'error_line': line,
        **(
            {
                'error_type': explanation.data['type'],
                'error_cause': explanation.data['message'],
                'error_facts': explanation.data['facts'],
            }
            if explanation
            else {}
        ),
        **({'unread': unread} if unread else {}),
    }


def _declared(argument: Any) -> list[Any]:
    default = None if argument.default_value is None else ' + '.join(part.describe() for part in argument.default_value)
    place = argument.origin or (None, None)
    return [argument.name, default, argument.description, argument.choices, place[0], place[1]]


def note_launch_files(process: Process, path: str) -> None:
    """Record the launch file of a typed `ros2 launch` and its includes as a fact (`launch files`).

    A launch may start no program, so no other record would contain these files.
    """
    files = [process.index.source_path(file) for file in (path, *process.state.get('launch.includes', ()))]
    process.fact('launch files', None, {'files': files})


def note_unread_arguments(process: Process, given: Iterable[str]) -> None:
    """Record the unused arguments of a typed `ros2 launch` as facts (`argument unread`); see :class:`UnreadArgument`."""
    for one in _unread_arguments(process, given):
        process.fact('argument unread', (one.name, one.included), one._asdict())


def _unread_arguments(process: Process, given: Iterable[str]) -> list[UnreadArgument]:
    """Yield launch arguments that no launch file declares or reads, and arguments of an include that its file does not declare.

    ROS 2 accepts such arguments without a message.
    """
    state, source = process.state, process.index.source_path
    read, names = state.get('launch.read', ()), [argument.name for argument in state.get('launch.declared', ())]
    found = [UnreadArgument(name, names, None, None, None) for name in given if name not in names and name not in read]
    for name, declared, file, origin in state.get('launch.undeclared', ()):
        place = (None, None) if origin is None else (source(origin.file), origin.line)
        one = UnreadArgument(name, list(declared), source(file), *place)
        found += [one] if name not in read and one not in found else []
    return found

"""The programs that the trusted peer hosts at the request of the confined peer.

These are the programs of edulaunch, except for a few that read a student's files or keys.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.parameter_files import Entry, ParameterFileError
from edulaunch.engine.packages import Program
from edulaunch.engine.packages.absent import absent_kind
from edulaunch.engine.packages.prefix import Underlay
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.programs import run_program
from edulaunch.engine.processes.spec import Origin, ProcessSpec
from edulaunch.engine.sim.task import current_task
from edulaunch.engine.underlay_place import underlay_prefix
from edulaunch.runtime.first_starts import FirstStarts
from edulaunch.runtime.link.codec import FrameKind, Violation, load
from edulaunch.runtime.link.peer import Peer, TooManyPrograms
from edulaunch.runtime.link.provenance import HostedProgram

OF_THE_STUDENT = {
    'joint_state_publisher': None,
    'joint_state_publisher_gui': None,
    'launch_testing': None,
    'robot_state_publisher': None,
    'rviz2': None,
    'teleop_twist_keyboard': None,
    'tf2_tools': None,
    'turtlesim': ('turtle_teleop_key',),
    'xacro': None,
}
"""Programs that read files or keys, so they run beside the student's own. None means all executables of the package."""


@cache
def _underlay() -> Underlay:
    return Underlay(underlay_prefix())


def hosted_program(package: str, executable: str) -> Program | None:
    """Return the program with that package and executable if the trusted peer hosts it, otherwise None."""
    own = OF_THE_STUDENT.get(package, ())
    return None if own is None or executable in own else _underlay().program(package, executable)


def is_hosted(program: Program | None) -> bool:
    """Return whether the trusted peer has exactly this program."""
    if program is None or program.kind != 'entry_point':
        return False
    ours = hosted_program(program.package, program.executable)
    return ours is not None and (ours.module, ours.function) == (program.module, program.function)


def shipped_path(package: str | None, executable: str | None) -> str:
    """Return the path that starts a stock program as the first word of a command line."""
    return os.path.join(underlay_prefix(), 'lib', package or '', executable or '')


def is_shipped(word: str) -> bool:
    """Return whether the first word of a command line is a path in the folder for programs of edulaunch."""
    return os.path.normpath(word).startswith(os.path.join(underlay_prefix(), 'lib', ''))


def runs_beside_the_student(package: str | None, executable: str | None, word: str) -> bool:
    """Return whether the confined peer itself runs the stock program with this path."""
    if word != shipped_path(package, executable) or hosted_program(package or '', executable or '') is not None:
        return False
    is_stand_in = package is not None and absent_kind(package) is not None  # such a program reports what is missing, and ends
    return is_stand_in or _underlay().program(package or '', executable or '') is not None


MOST_PROGRAMS = 2000


class TrustedHost(FirstStarts, Host):
    """Hosts the programs of edulaunch. It starts no program of the system, and does not search the student's files for programs.

    :ivar identified: the program of each process that runs in this peer, by process ID.
    :ivar late_s: for each executable, the delay of its first start in simulated seconds. The second start has twice
        this delay, and so on.
    :ivar fails: as in `FirstStarts`, for the programs of both peers.
    """

    peer: Peer
    identified: dict[int, HostedProgram]
    late_s: Mapping[str, float] = MappingProxyType({})

    def may_start(self, payload: memoryview) -> bool:
        """Return whether a program can be started."""
        return not self.refuses(text_of(load(bytes(payload))))

    def spawn(self, payload: memoryview) -> None:
        """Start a program at the request of the confined peer."""
        pid, argv, package, executable, data = load(bytes(payload))
        spec = spec_from_data(data)
        program = hosted_program(text_of(package), text_of(executable))
        _check_words(spec, argv)
        is_called_so = spec.argv[:1] == (shipped_path(spec.package, spec.executable),)
        if program is None or (is_called_so and (spec.package, spec.executable) != (package, executable)):
            raise Violation('not a program that is hosted here')
        if self.refused_now(program.executable) is not None:
            raise Violation('the other peer must ask before it starts a program')
        self.identified[self.their_pid(pid)] = HostedProgram(program.package, program.executable)
        count = sum(known.executable == program.executable for known in self.identified.values())
        late_ns = round(self.late_s.get(program.executable, 0.0) * 1e9) * count

        def main(process: Process) -> object:
            if late_ns:
                current_task().sleep_until(self.sim.now_ns + late_ns)
            return run_program(process, program)

        process = Process(self, spec, pid, argv, main)
        process.on_output = lambda stream, text: self.peer.call(FrameKind.OUTPUT, [pid, stream, text])
        process.on_exit = lambda code: self.peer.call(FrameKind.EXIT, [pid, code, process.exception])
        self.adopt(process)

    def their_pid(self, pid: Any) -> int:
        """Check that the confined peer has named the next process ID, and return it."""
        if pid != self.next_pid():
            raise Violation('programs must be numbered in order')
        if pid >= 1000 + MOST_PROGRAMS:
            raise TooManyPrograms
        return int(pid)

    def hosted(self, pid: Any) -> Process | None:
        """Return the hosted program with that process ID, or None if it has ended."""
        return next((each for each in self.processes if each.pid == pid), None)

    def send_signal(self, payload: memoryview) -> None:
        """Deliver a signal to a hosted program."""
        pid, signum = load(bytes(payload))
        process = self.hosted(pid)
        if process is not None and 0 < signum < 65:
            process.send_signal(signum)

    def hear(self, payload: memoryview) -> None:
        """Set whether the output of a hosted program is recorded."""
        pid, is_recorded = load(bytes(payload))
        process = self.hosted(pid)
        if process is not None:
            process.is_recorded = is_recorded is True

    def parameter_entries(self, path: str) -> Sequence[Entry]:
        """Return the parameters in a file, which the confined peer reads; see `Host.parameter_entries`."""
        program = self.program_here()
        answer = self.peer.call(FrameKind.ENTRIES, [path, (program and program.cwd) or ''])
        if isinstance(answer, list):
            return [_entry(row) for row in answer]
        raise _reading_error(answer)


def _entry(row: Any) -> Entry:
    pattern, name, value, line = row
    if not (isinstance(pattern, str) and isinstance(name, str) and isinstance(line, int) and _is_value(value)):
        raise Violation('no parameter')
    return Entry(pattern, name, value, line)


def _is_value(value: Any) -> bool:
    if isinstance(value, list):
        return all(isinstance(each, (bool, int, float, str)) for each in value)
    return value is None or isinstance(value, (bool, int, float, str))


def _reading_error(answer: Any) -> Exception:
    if 'reason' in answer:
        error = ParameterFileError(text_of(answer['reason']))
        return with_facts(error, text_of(answer['facts'].pop('about')), **answer['facts']) if answer['facts'] else error
    if 'coding' in answer:
        encoding, wrong, start, end, reason = answer['coding']
        if not (0 <= start < end < 1 << 26 and isinstance(wrong, bytes)):
            raise Violation('not a place in a file')
        return UnicodeDecodeError(text_of(encoding), bytes(start) + wrong, start, end, text_of(reason))
    number, text, file = answer['system']
    return OSError(int(number), text_of(text), text_of(file))


def text_of(value: Any) -> str:
    """Return a value that must be a string. Raise Violation for any other value."""
    if not isinstance(value, str):
        raise Violation('no text')
    return value


def _check_words(spec: ProcessSpec, argv: Any) -> None:
    """Check that the arguments of a program are the last words of the command line in the recording."""
    words = shlex.split(' '.join(spec.argv)) if spec.shell else list(spec.argv)
    if not isinstance(argv, list) or not argv or words[-len(argv) :] != argv:
        raise Violation('a program must match its command line')


def spec_from_data(data: Any) -> ProcessSpec:
    """Return the spec that `confined.spec_as_data` described.

    :raises Violation: for invalid data.
    """
    argv, name, cwd, env, shell, origin, package, executable, origins, emulate_tty, has_pipe = data
    texts = [*argv, name, *(env or {}).values(), *origins.values()]
    maybe = [cwd, package, executable]
    if not (all(isinstance(text, str) for text in texts) and all(text is None or isinstance(text, str) for text in maybe)):
        raise Violation('no command')
    return ProcessSpec(
        argv=tuple(argv),
        name=name,
        cwd=cwd,
        env=MappingProxyType(dict(env or {})),
        shell=shell is True,
        origin=None if origin is None else Origin(text_of(origin[0]), int(origin[1])),
        package=package,
        executable=executable,
        parameter_origins=dict(origins),
        emulate_tty=emulate_tty is True,
        has_pipe=has_pipe is True,
    )

"""Observe a real run through an additional node, and through the output of its processes."""

from __future__ import annotations

import base64
import fcntl
import json
import os
import queue
import random
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from edulaunch.engine.packages import Program as Executable
from edulaunch.engine.packages.index import interfaces_of
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.errors import EdulaunchError
from edulaunch.extras.comparing.observation import (
    BRIEFLY,
    NOT_COMPARED,
    End,
    Flow,
    Line,
    Observation,
    Program,
    add_messages,
    is_compared,
    lines_of,
    program_of,
    steady_name,
)
from edulaunch.extras.native.command import command
from edulaunch.extras.native.host import NativeHost
from edulaunch.extras.native.loopback import confined
from edulaunch.extras.network.native_session import NativeSession
from edulaunch.ros.serialization.cdr import decode
from edulaunch.runtime.session import Session

END_S = 15.0
"""The seconds after Ctrl-C until launch kills programs that still run."""
LOOK_EVERY_S = 0.5
DOMAINS = range(70, 100)
"""ROS_DOMAIN_IDs that are safe on every system and rarely used."""
FIRST_PORT, PORTS_OF_DOMAIN, MOST_PROGRAMS = 7400, 250, 100
"""The ports of DDS. The first port of a domain is for multicast, and each program has two ports from the tenth on."""
_OBSERVER = Executable('entry_point', '', 'observer', 'observer', module='edulaunch.extras.native.observer', function='main')
IsEnough = Callable[[Observation], bool]


def run_for_real(
    path: str,
    file: str | None,
    arguments: Mapping[str, str],
    seconds: float,
    workspaces: Sequence[str],
    is_enough: IsEnough = lambda seen: True,
    patience_s: float = 0.0,
) -> Observation:
    """Launch a file in a separate domain of this computer, press Ctrl-C, and return the observation.

    :param seconds: the duration of the run, which is extended by up to `patience_s` until `is_enough` accepts the observation.
    :raises UnusableInput: when the file cannot be launched, or the real rclpy is not installed.
    :raises KeyboardInterrupt: when the user pressed Ctrl-C before the end of the run.
    """
    # a shell ignores SIGINT for background jobs, and programs would inherit that
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    with _domain() as domain:
        env = {**os.environ, 'ROS_DOMAIN_ID': str(domain), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}
        with NativeSession(workspaces=workspaces, env=env) as session, _observer(session) as ask:
            watch = _Watch(session)
            launch = session.launch(path, file, arguments)
            _run(session, seconds)
            watch.add(ask('look'))
            while not session.is_over and watch.now_s < seconds + patience_s and not is_enough(watch.seen()):
                _run(session, LOOK_EVERY_S)
                watch.add(ask('look'))
            launch.raise_error()
            watch.add(ask('end'))
            asked_s = watch.now_s
            session.interrupt()
            _run(session, END_S)
            return watch.seen()._replace(asked_s=asked_s)


def _run(session: Session, seconds: float) -> None:
    """Wait while real time passes.

    :raises KeyboardInterrupt: when the user pressed Ctrl-C. The observation until then cannot be compared.
    """
    if session.run(seconds, speed=1.0):
        raise KeyboardInterrupt


@contextmanager
def _domain() -> Iterator[int]:
    """Reserve an empty domain that no other comparison on this computer uses at the same time."""
    for number in random.SystemRandom().sample(DOMAINS, len(DOMAINS)):
        with open(os.path.join(tempfile.gettempdir(), f'edulaunch-{os.getuid()}-domain-{number}'), 'w') as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                continue
            if is_empty(number):
                yield number
                return
    first, last = DOMAINS[0], DOMAINS[-1]
    raise EdulaunchError(
        f'none of the domains {first} to {last} is empty on this computer.',
        help='wait for the end of other comparisons, or end the programs with such a ROS_DOMAIN_ID',
    )


def is_empty(domain: int) -> bool:
    """Return whether a domain contains no program of this computer. Each program in a domain uses a port."""
    first = FIRST_PORT + PORTS_OF_DOMAIN * domain
    return all(map(_is_free, (first, *range(first + 10, first + 10 + 2 * MOST_PROGRAMS))))


def _is_free(port: int) -> bool:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as trial:
        try:
            trial.bind(('', port))
        except OSError:
            return False
    return True


@contextmanager
def _observer(session: Session) -> Iterator[Callable[[str], Any]]:
    """Start a node that observes the run and reports on request, while the session continues.

    :raises EdulaunchError: when the observer did not start, or ended unexpectedly.
    """
    assert isinstance(session.host, NativeHost)
    words = command(session.host.environment, _OBSERVER, ProcessSpec((), 'observer'), session.index)
    pipes: dict[str, Any] = {'stdin': subprocess.PIPE, 'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE}
    env = confined(session.host.env)
    env.pop('PYTHONPATH', None)  # in an active terminal it leads to the simulated rclpy
    with subprocess.Popen([*words, 'observer'], env=env, text=True, start_new_session=True, **pipes) as child:
        assert child.stdin is not None and child.stdout is not None and child.stderr is not None
        tell, lines = child.stdin, iter(child.stdout.readline, '')
        answers: queue.SimpleQueue[str] = queue.SimpleQueue()

        def hear() -> None:
            for line in lines:
                answers.put(line)
            answers.put('')

        def ask(word: str) -> Any:
            tell.write(f'{word}\n')
            tell.flush()
            while answers.empty() and not session.is_over:
                _run(session, 0.05)
            answer = answers.get()
            if not answer:
                raise EdulaunchError('the observer of the real run died.')
            return json.loads(answer)

        try:
            if next(lines, '') != 'ready\n':
                raise EdulaunchError('the observer of the real run did not start:\n' + ''.join(child.stderr.readlines()[-5:]))
            threading.Thread(target=hear, daemon=True).start()
            yield ask
        finally:
            child.kill()


class _Watch:
    """The reports of a run's observer so far, and the output of the run's processes.

    Times are in seconds since the creation of this object.
    """

    def __init__(self, session: Session) -> None:
        assert isinstance(session.host, NativeHost)
        self._host, self._began_s = session.host, time.time()
        self._registry = interfaces_of(session.index)[1]
        self._nodes: dict[str, float] = {}
        self._ends: dict[End, tuple[str, float]] = {}
        self._flows: dict[str, Flow] = {}
        self._parameters: dict[str, dict[str, Any]] = {}

    def add(self, report: Any) -> None:
        """Add a report of the observer."""
        self._nodes.update(
            {steady_name(node): when - self._began_s for node, when in report['nodes'].items() if is_compared(node)}
        )
        for kind, name, type_name, node, qos, when in report['ends']:
            if is_compared(node):
                self._ends.setdefault(End(kind, steady_name(name), type_name, steady_name(node)), (qos, when - self._began_s))
        for topic, (type_name, rows) in report['messages'].items():
            if topic not in NOT_COMPARED and rows:
                cls: Any = self._registry.get(type_name)
                wires = ((when - self._began_s, decode(cls, base64.b64decode(data))) for when, data in rows)
                add_messages(self._flows, topic, type_name, wires, self._registry.get)
        self._parameters = {steady_name(node): values for node, values in report['parameters'].items()}

    @property
    def now_s(self) -> float:
        """Return the duration of the run so far, in seconds."""
        return time.time() - self._began_s

    def seen(self) -> Observation:
        """Return the observation so far."""
        lines: list[Line] = []
        programs: dict[str, Program] = {}
        began_s = self._began_s
        for run in self._host.runs:
            for stream in ('stdout', 'stderr'):
                pieces = [(when - began_s, text) for when, each, text in run.written if each == stream]
                lines += lines_of(program_of(run.name), pieces)
            ended_s = None if run.ended_s is None else run.ended_s - began_s
            signalled_s = run.signalled_s - began_s
            spoke_s = run.written[0][0] - began_s if run.written else BRIEFLY
            programs[run.name] = Program(run.started_s - began_s, ended_s, run.returncode, frozenset(), signalled_s, spoke_s)
        return Observation(self._nodes, self._ends, self._parameters, self._flows, lines, programs, self.now_s, began_s)

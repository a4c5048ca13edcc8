"""The confined peer of one run. It launches the submission, and has a link to the trusted peer.

`starter.py` loads this module. The peer confines itself before it reads the student's file, does not import edugrade, and records
nothing. It also has a pipe for messages about its end. Each message is a frame of a letter, eight bytes of length, and JSON (see
`trusted_peer.py`).
"""

from __future__ import annotations

import json
import os
import signal
import socket
from collections.abc import Callable
from contextlib import suppress
from types import FrameType
from typing import Any, NoReturn

WARM_UP_S = 3.1  # simulated time after which turtle2 of the demo looks up transforms
OFTEN = (
    *('argparse', 'hashlib', 'pathlib', 'yaml', 'edulaunch.engine.processes.module_views.chance_views'),
    *('edulaunch.engine.processes.module_views.os_views', 'edulaunch.engine.processes.module_views.thread_views'),
    *('edulaunch.engine.worlds.planar_robot', 'edulaunch.ros.serialization.message_text'),
    *('launch.actions.group_action', 'launch.actions.opaque_function', 'launch.actions.register_event_handler'),
    *('launch.actions.timer_action', 'launch.conditions.if_condition', 'launch.event_handlers.on_process_exit'),
    *('launch.event_handlers.on_process_start', 'launch.launch_description_sources.python_launch_description_source'),
    *('launch.substitutions.equals_substitution', 'launch.substitutions.path_join_substitution'),
    *('launch.substitutions.python_expression', 'tf2_ros.static_transform_broadcaster'),
)
"""Modules that only some runs load. For a class, it is worth loading them once."""
OFTEN_TYPES = ('nav_msgs/msg/Odometry', 'sensor_msgs/msg/LaserScan', 'std_msgs/msg/String', 'std_msgs/msg/Int32')
WORDS, LINK = 3, 4  # the only descriptors other than input and output
MOST_DESCRIPTORS = 4096
RESERVE_BYTES = 8 << 20  # memory that is kept free for the report that memory has run out


def warm_up() -> None:
    """Load the modules that nearly every run needs, by launching a small demo of edulaunch.

    :raises RuntimeError: if the launch fails, for example because memory runs out while a module loads. Every run that is
        forked from this process would fail, too, and students would lose marks.
    """
    from edulaunch.runtime.session import Session

    with Session(turn_limit_s=0) as session:  # without a watchdog, because a process with threads must not be forked
        launch = session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
        session.run(WARM_UP_S)
        recording = session.recording()
        recording.to_bytes()
        if launch.process.returncode is not None or any(process.returncode is not None for process in recording.processes):
            raise RuntimeError('the first launch of this process failed')
    import tempfile
    import traceback  # noqa: F401  (for _broke)

    import edulaunch.runtime.link.confined
    import edulaunch.runtime.link.trusted  # noqa: F401

    tempfile.tempdir = None  # each run has its own folder


def warm_up_for_many() -> None:
    """Load modules and message types that only some runs need.

    If a module is not installed, this process continues, and a run reports what is missing.
    """
    from importlib import import_module

    from edulaunch.engine.interfaces.registry import underlay_registry

    for name in OFTEN:
        with suppress(ModuleNotFoundError):
            import_module(name)
    for name in OFTEN_TYPES:
        underlay_registry().get(name)


def run(job: dict[str, Any], link: socket.socket, words: int, confine: Callable[[list[str], str], dict[str, str]]) -> NoReturn:
    """Run the confined peer in a forked process: enter the sandbox, lower the limits, and launch.

    :param job: the input of the run; see `RunRequest.message`.
    :param link: the link to the trusted peer.
    :param words: a pipe for the report on the confinement, and for the last message.
    :param confine: a function that applies the layers of confinement. Its arguments are the readable paths and the writable
        folder. It returns which layers hold.
    """
    os.setsid()
    try:
        state = {} if job['sandbox'] == 'off' else confine(job['readable'], job['home'])
        repeat_temporary_names(job['seed'])
    except OSError as error:
        send(words, *_broke(error))
        os._exit(0)
    high = os.dup(words), os.dup(link.fileno())  # use numbers above the two targets
    words, end = os.dup2(high[0], WORDS), os.dup2(high[1], LINK)
    link.detach()
    os.closerange(LINK + 1, MOST_DESCRIPTORS)
    limit_resources(job['limits'])
    send(words, b'C', json.dumps(state).encode())
    if job['sandbox'] == 'require' and any(text != 'held' for layer, text in state.items() if layer != 'view'):
        os._exit(0)  # the runner reports the reason
    answer_before_the_deadline(job, words)
    limit_single_calls(2.5 * job['turn_s'])
    reserve = bytes(RESERVE_BYTES)  # address space, which is limited; unlike a bytearray, it needs no memory
    try:
        letter, content = attempt(job, socket.socket(fileno=end))
    except MemoryError:  # memory may also run out while another failure is being described
        del reserve
        letter, content = b'S', b'{"reason": "memory"}'
    if hasattr(signal, 'setitimer'):
        signal.setitimer(signal.ITIMER_REAL, 0.0)  # a second alarm must not interrupt the answer
    send(words, letter, content)
    os._exit(0)


def repeat_temporary_names(seed: int) -> None:
    """Make `tempfile` choose the same names in each run, because reports show these names. The folder is private to the run.

    :raises OSError: if nothing can be written in this folder. Later, only the submission can be the cause.
    """
    import tempfile
    from random import Random

    tempfile.gettempdir()
    names: Any = tempfile._get_candidate_names()  # type: ignore[attr-defined]
    names._rng, names._rng_pid = Random(seed), os.getpid()


def limit_single_calls(seconds: float) -> None:
    """End the process if one call into C (``9**9**9``, a slow pattern) uses that much processor time or more.

    While Python code runs, a timer keeps moving the limit. If a call does not return, its place is printed, and the system
    ends the process with SIGXCPU.
    """
    try:
        import faulthandler
        import resource
    except ImportError:
        return

    def move_on(signum: int, frame: FrameType | None) -> None:
        used = resource.getrusage(resource.RUSAGE_SELF)
        hard = resource.getrlimit(resource.RLIMIT_CPU)[1]
        soft = int(used.ru_utime + used.ru_stime + seconds) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (soft if hard == resource.RLIM_INFINITY else min(soft, hard), hard))

    faulthandler.register(signal.SIGXCPU, file=1, all_threads=False, chain=True)
    signal.signal(signal.SIGPROF, move_on)
    signal.setitimer(signal.ITIMER_PROF, seconds / 8, seconds / 8)
    move_on(0, None)


def limit_resources(limits: dict[str, int]) -> None:
    """Lower the limits of this process permanently. Limits that the system does not support (such as AS on macOS) are left
    out.
    """
    try:
        import resource
    except ImportError:
        return
    for name, value in limits.items():
        kind = getattr(resource, f'RLIMIT_{name}', None)
        if kind is None:
            continue
        hard = resource.getrlimit(kind)[1]
        lowered = value if hard == resource.RLIM_INFINITY else min(value, hard)
        try:
            resource.setrlimit(kind, (lowered, lowered))
        except (ValueError, OSError):
            continue


def answer_before_the_deadline(job: dict[str, Any], words: int) -> None:
    """Set an alarm that reports, shortly before the deadline, where the program is, and ends this process.

    (The trusted peer ends a run that does not report this.)
    """

    def on_alarm(signum: int, frame: FrameType | None) -> None:
        report: dict[str, Any] = {'reason': 'timeout'}
        place = innermost(frame, job)
        if place is not None:
            report['file'], report['line'] = place
        send(words, b'S', json.dumps(report).encode())
        os._exit(0)

    if hasattr(signal, 'setitimer'):
        signal.signal(signal.SIGALRM, on_alarm)
        signal.setitimer(signal.ITIMER_REAL, job['wall_s'])


def innermost(frame: FrameType | None, job: dict[str, Any]) -> tuple[str, int] | None:
    """Return the file and line of the innermost frame in the student's code, or None if there is no such frame."""
    folder = os.path.realpath(job['folder']) + os.sep  # links lead to the files of a package
    while frame is not None:
        file = os.path.realpath(frame.f_code.co_filename)
        if file.startswith(folder):
            return file, frame.f_lineno
        frame = frame.f_back
    return None


def attempt(job: dict[str, Any], link: socket.socket) -> tuple[bytes, bytes]:
    """Take part in the run until the trusted peer ends it. If that fails, return the letter and content of a frame with the
    reason.
    """
    try:
        # Import the modules that a failure needs while there is memory: CPython ends with SIGSEGV if an import runs out of
        # memory.
        import pathlib  # noqa: F401
        import traceback  # noqa: F401

        from edulaunch.errors import UnusableInput
        from edulaunch.runtime.link.confined import ConfinedSession
    except ImportError as error:
        return _broke(error)
    try:
        session = ConfinedSession(link, seed=job['seed'], workspaces=job['workspaces'], turn_limit_s=job['turn_s'])
        session.launch(job['file'], None, job['arguments'])
        if job['is_interrupted']:  # interrupt after the recorded time; the trusted peer runs a little longer for this
            session.sim.schedule(session.sim.now_ns + round(job['duration_s'] * 1e9) + 1, session.interrupt)
        session.run_as_asked()
        os._exit(0)
    except UnusableInput as error:
        return b'U', json.dumps({'text': error.message, 'help': error.help}).encode()
    except MemoryError:
        raise  # main reports it
    except SystemError as error:
        bytearray(2 * RESERVE_BYTES)  # CPython can raise this error when memory runs out, so treat it as a MemoryError
        return _broke(error)
    except BaseException as error:
        return _broke(error)


def _broke(error: BaseException) -> tuple[bytes, bytes]:
    import traceback

    text = ''.join(traceback.format_exception(type(error), error, error.__traceback__))
    return b'B', json.dumps({'text': f'{type(error).__name__}: {error}', 'trace': text[-8000:]}).encode()


def send(channel: int, letter: bytes, content: bytes) -> None:
    """Write one complete frame."""
    for part in (letter + len(content).to_bytes(8, 'big'), content):
        view = memoryview(part)
        while view:
            view = view[os.write(channel, view) :]

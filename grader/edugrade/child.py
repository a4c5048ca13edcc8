"""The untrusted half: runs one scenario of a submission and sends back what happened.

Loaded by `starter.py`, which forks for each run; the run limits itself before it reads the student's file. It imports
nothing of edugrade, and answers with one frame of plain data: a letter, eight bytes of length, content.

====== ===========================================================================
letter content
====== ===========================================================================
R      the recording's bytes
U      JSON: the launch file cannot be run (the student's mistake, in ROS 2's words)
S      JSON: the run was stopped: 'timeout' or 'memory'
B      JSON: edulaunch itself broke
====== ===========================================================================
"""

from __future__ import annotations

import json
import os
import signal
from types import FrameType
from typing import Any, NoReturn

WARM_UP_S = 3.1  # of simulated time: from then on the demo's turtle2 looks up transforms
LONGEST_JOIN_S = 2.0
RESERVE_BYTES = 8 << 20  # kept free, so that there is room to say that memory has run out


def warm_up() -> None:
    """Load what nearly every run needs, by launching something small that came with edulaunch."""
    try:
        import edulaunch

        with edulaunch.Session() as session:
            session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
            session.run(WARM_UP_S)
            session.recording().to_bytes()
    except Exception:
        return  # the runs meet the same, and say so
    import gc
    import tempfile
    import threading
    import traceback  # noqa: F401  (for _broke)

    for thread in threading.enumerate():
        if thread is not threading.main_thread():
            thread.join(LONGEST_JOIN_S)  # the engine's watchdog: a process with threads must not be forked
    tempfile.tempdir = None  # each run has its own
    gc.collect()
    gc.freeze()  # the runs share what is loaded


def run(job: dict[str, Any], channel: int, output: int) -> NoReturn:
    """Be one run, in a process that was just forked: move house, lower the limits, launch, answer."""
    os.setsid()
    null = os.open(os.devnull, os.O_RDONLY)
    for source, target in ((null, 0), (output, 1), (output, 2)):
        os.dup2(source, target)
    os.close(null)
    os.close(output)
    os.chdir(job['home'])
    os.environ.clear()
    os.environ.update(job['environment'])
    limit_resources(job['limits'])
    answer_before_the_deadline(job, channel)
    reserve = bytearray(RESERVE_BYTES)
    try:
        letter, content = attempt(job)
    except MemoryError:  # also one that came up while another failure was being put into words
        reserve.clear()
        letter, content = b'S', b'{"reason": "memory"}'
    send(channel, letter, content)
    os._exit(0)


def limit_resources(limits: dict[str, int]) -> None:
    """Lower this process's limits for good. A system that lacks a limit (AS on macOS) goes without it."""
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


def answer_before_the_deadline(job: dict[str, Any], channel: int) -> None:
    """When time is nearly up, say where the program was. (The runner kills what does not answer.)"""

    def on_alarm(signum: int, frame: FrameType | None) -> None:
        report: dict[str, Any] = {'reason': 'timeout'}
        place = innermost(frame, job)
        if place is not None:
            report['file'], report['line'] = place
        send(channel, b'S', json.dumps(report).encode())
        os._exit(0)

    if hasattr(signal, 'setitimer'):
        signal.signal(signal.SIGALRM, on_alarm)
        signal.setitimer(signal.ITIMER_REAL, job['wall_s'])


def innermost(frame: FrameType | None, job: dict[str, Any]) -> tuple[str, int] | None:
    """File and line of the innermost frame that is the student's, if any."""
    folder = os.path.realpath(job['folder']) + os.sep  # files of a package are run through links
    while frame is not None:
        file = os.path.realpath(frame.f_code.co_filename)
        if file.startswith(folder):
            return file, frame.f_lineno
        frame = frame.f_back
    return None


def attempt(job: dict[str, Any]) -> tuple[bytes, bytes]:
    """Run the scenario; what it came to, as a frame's letter and content."""
    try:
        import edulaunch
        from edulaunch.errors import UnusableInput
    except ImportError as error:
        return _broke(error)
    try:
        with edulaunch.Session(seed=job['seed'], workspaces=job['workspaces']) as session:
            session.launch(job['file'], None, job['arguments'])
            session.run(job['duration_s'])
            return b'R', session.recording().to_bytes()
    except UnusableInput as error:
        return b'U', json.dumps({'text': error.message, 'help': error.help}).encode()
    except MemoryError:
        raise  # to main, which has words for it
    except SystemError as error:
        bytearray(2 * RESERVE_BYTES)  # CPython stumbles when memory runs out in its middle: then this is a MemoryError
        return _broke(error)
    except BaseException as error:
        return _broke(error)


def _broke(error: BaseException) -> tuple[bytes, bytes]:
    import traceback

    text = ''.join(traceback.format_exception(type(error), error, error.__traceback__))
    return b'B', json.dumps({'text': f'{type(error).__name__}: {error}', 'trace': text[-8000:]}).encode()


def send(channel: int, letter: bytes, content: bytes) -> None:
    """Write one frame, all of it."""
    for part in (letter + len(content).to_bytes(8, 'big'), content):
        view = memoryview(part)
        while view:
            view = view[os.write(channel, view) :]

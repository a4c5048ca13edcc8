"""The starter: a process that loads the engine once, and forks itself for each run.

`starter_link.py` starts it as a separate script with its own environment (``-I`` would ignore PYTHONHASHSEED). It reads no
submission: a run does so after the fork with `child.py`, in its own confined process, session and folder. So every run begins
in the same clean state, and 400 modules are loaded once instead of once for each run.

The forkserver of the standard library is not sufficient. Its children inherit the caller's environment and hash seed. It
unpickles its input, forgets a child's pid before the group could be killed, and has no place for a guard.

A message is JSON after four bytes with its length. The first message is Python's module search path. The second message contains
the paths that every run may read, and whether there will be many runs. After that, each run has a message with its job and three
descriptors: the channel, the output and the guard's link.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import socket
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from importlib.util import module_from_spec, spec_from_file_location
from types import ModuleType
from typing import Any, NoReturn

LENGTH_BYTES = 4
LAST_LOOKS = 300
MOST_DESCRIPTORS = 4096  # a run closes this many descriptors before it begins
HERE = os.path.dirname(os.path.abspath(__file__))


def main() -> NoReturn:
    control = socket.socket(fileno=int(sys.argv[1]))
    control.set_inheritable(False)
    sys.argv[1:] = []
    gc.disable()  # there is little to collect while modules load
    sys.path[:] = _message(control)
    open_many()
    confine, guard, trusted_peer, system = _load_sandbox()
    child = _load_child()
    try:
        child.warm_up()
        places = _message(control)
        if places.pop('is_for_many'):
            child.warm_up_for_many()
    except Exception:
        os._exit(1)  # the grader starts another one, and gives no mark if that one fails, too
    # The runs share the loaded modules. The garbage of the first launch stays, because collecting it takes a tenth of this time.
    gc.freeze()
    gc.enable()
    confinement = confine.Confinement(**places)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # guards report errors themselves, so nothing waits for their exit codes
    while True:
        header, descriptors, _, _ = socket.recv_fds(control, LENGTH_BYTES, 3)
        if len(header) < LENGTH_BYTES:
            leave_nothing()
        job = json.loads(_exactly(control, int.from_bytes(header, 'big')))
        try:
            if system.fork() == 0:
                control.close()
                run = partial(_be_a_run, job, (descriptors[0], descriptors[1]), child, confinement, trusted_peer)
                _begin(job, descriptors, run, guard)
        except OSError as error:  # also in the new process, which has not become the guard then
            with suppress(OSError):
                trusted_peer.send(descriptors[0], *trusted_peer.broke(error))
            if control.fileno() < 0:
                os._exit(1)
        for descriptor in descriptors:
            os.close(descriptor)


def open_many() -> None:
    """Raise the limit on open files, so that this process can open a file for each installed package."""
    with suppress(ImportError, ValueError, OSError):
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        if 0 <= soft < MOST_DESCRIPTORS:
            resource.setrlimit(resource.RLIMIT_NOFILE, (MOST_DESCRIPTORS if hard < 0 else min(MOST_DESCRIPTORS, hard), hard))


def leave_nothing() -> NoReturn:
    """End this process after the grader has ended.

    If the grader was killed, its private folder still exists. Wait until the guards have emptied the folder, and remove it.
    """
    folder = os.path.dirname(os.getcwd())
    for _ in range(LAST_LOOKS):
        with suppress(OSError):
            for name in os.listdir(folder):  # the folders of this starter and of earlier ones
                with suppress(OSError):
                    os.rmdir(os.path.join(folder, name))
        try:
            os.rmdir(folder)
        except FileNotFoundError:
            break
        except OSError:
            time.sleep(0.01)
    os._exit(0)


def _begin(job: dict[str, Any], descriptors: list[int], run: Callable[[socket.socket], NoReturn], guard: Any) -> NoReturn:
    """Become the guard of a run."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    guard.guard(socket.socket(fileno=descriptors[2]), job['home'], job['tree_memory'], run)
    os._exit(0)


def _be_a_run(
    job: dict[str, Any], ends: tuple[int, int], child: Any, confinement: Any, trusted_peer: Any, notes: socket.socket
) -> NoReturn:
    """Enter the run's folder, and become the trusted peer of the run, whose child is the confined peer."""
    try:
        peer = _peer(job, ends, child, confinement, trusted_peer, notes)
    except BaseException as error:  # the run has not read anything of the submission
        trusted_peer.send(ends[0], *trusted_peer.broke(error))
        os._exit(0)
    peer.run()
    os._exit(0)


def _peer(
    job: dict[str, Any], ends: tuple[int, int], child: Any, confinement: Any, trusted_peer: Any, notes: socket.socket
) -> Any:
    """Fork the confined peer, confine this process, and return it as the trusted peer."""
    channel, output = ends
    os.setsid()
    for target in (1, 2):
        os.dup2(output, target)
    os.close(output)
    os.chdir(job['home'])
    os.environ.clear()
    os.environ.update(job['environment'])

    view = {} if job['sandbox'] == 'off' else confinement.narrow_view(job['readable'], job['home'])
    # opened in this view, where it is read-only, because a run can change the mode of open files
    null = os.open(os.devnull, os.O_RDONLY)
    os.dup2(null, 0)
    os.close(null)

    def confine(readable: list[str], home: str) -> dict[str, str]:
        return {**confinement.put_on(readable, home, notes), **view}

    def confined(link: socket.socket, words: int) -> NoReturn:
        try:
            child.run(job, link, words, confine)
        finally:
            os._exit(1)  # the submission was not read, or the failure could not be reported

    peer = trusted_peer.TrustedPeer(job, channel, confined)
    notes.close()
    if job['sandbox'] != 'off':
        # this peer reads no file of the student; the report describes the sandbox of the other peer
        confinement.put_on([], job['home'])
    confinement.let_go()
    child.limit_resources(job['limits'])
    return peer


def _load_sandbox() -> tuple[Any, Any, Any, Any]:
    """Return the modules confine, guard, trusted_peer and system of this folder. They are not in `sys.modules`, so no run can
    find them.
    """
    spec = spec_from_file_location('edugrade_sandbox', os.path.join(HERE, '__init__.py'), submodule_search_locations=[HERE])
    assert spec is not None
    sys.modules['edugrade_sandbox'] = module_from_spec(spec)
    from edugrade_sandbox import confine, guard, system, trusted_peer  # type: ignore[import-not-found]

    for name in [name for name in sys.modules if name.startswith('edugrade_sandbox')]:
        del sys.modules[name]
    return confine, guard, trusted_peer, system


def _load_child() -> Any:
    """Return the module child.py. It is not in `sys.modules` either, and its frames do not count as the student's code."""
    child = ModuleType('edugrade_child')
    with open(os.path.join(HERE, 'child.py'), encoding='utf-8') as file:
        exec(compile(file.read(), '<frozen edugrade.child>', 'exec'), child.__dict__)
    return child


def _message(control: socket.socket) -> Any:
    return json.loads(_exactly(control, int.from_bytes(_exactly(control, LENGTH_BYTES), 'big')))


def _exactly(control: socket.socket, count: int) -> bytes:
    data = b''
    while len(data) < count:
        more = control.recv(count - len(data))
        if not more:
            leave_nothing()
        data += more
    return data


if __name__ == '__main__':
    main()

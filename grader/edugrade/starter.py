"""A warm interpreter that starts the runs: it loads the engine once, and becomes each run by forking.

Started by `starter_link.py` as a script of its own, with an environment made for it (``-I`` would leave PYTHONHASHSEED out).
It reads no submission: a run does so after the fork, in a process, session and folder of its own, with `child.py`. So every run
begins from the same clean state, and loading 400 modules is paid for once and not for each run.

Messages are JSON, a length of four bytes before each. From the runner: ``{"run": 3, "job": {...}}`` with two file
descriptors (the channel and the output), and ``{"reap": pid}``. To it: ``{"run": 3, "pid": 77}`` when a run has begun, and
``{"run": 3, "status": 0}`` when it has ended; its number stays taken until the runner says that it may be reaped.
"""

from __future__ import annotations

import json
import os
import select
import signal
import socket
import sys
from types import ModuleType
from typing import Any, NoReturn

LENGTH_BYTES = 4


def main() -> NoReturn:
    settings: dict[str, Any] = json.loads(sys.argv[1])
    sys.argv[1:] = []
    control = socket.socket(fileno=int(settings['control']))
    control.set_inheritable(False)
    sys.path[:] = settings['path']
    child = _load_child()
    child.warm_up()
    Starter(control, child).serve()
    os._exit(0)


def _load_child() -> Any:
    """The module child.py, which no run can find: it is not among the loaded ones, and no frame of it is the student's."""
    child = ModuleType('edugrade_child')
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'child.py'), encoding='utf-8') as file:
        exec(compile(file.read(), '<frozen edugrade.child>', 'exec'), child.__dict__)
    return child


class Starter:
    """Begins runs, and tells when they have ended.

    :param child: the module of the run, which has `run(job, channel, output)`.
    """

    def __init__(self, control: socket.socket, child: Any) -> None:
        self._control = control
        self._child = child
        self._runs: dict[int, int] = {}  # number of the run by process id, until it is reaped
        self._told: set[int] = set()
        self._reaped: set[int] = set()
        self._wake, self._wake_end = os.pipe()
        os.set_blocking(self._wake_end, False)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        signal.set_wakeup_fd(self._wake_end)

    def serve(self) -> None:
        """Do what the runner says until it is gone; then end what still runs."""
        while True:
            control = self._control.fileno()
            ready = select.select([control, self._wake], [], [])[0]
            if self._wake in ready:
                os.read(self._wake, 4096)
                self._tell_who_ended()
            if control in ready and not self._obey():
                break
        for pid in self._runs:
            os.killpg(pid, signal.SIGKILL)

    def _obey(self) -> bool:
        """Carry out one message; False when there is nobody to send any."""
        header, descriptors, _, _ = socket.recv_fds(self._control, LENGTH_BYTES, 2)
        if len(header) < LENGTH_BYTES:
            return False
        message = json.loads(self._exactly(int.from_bytes(header, 'big')))
        if 'reap' in message:
            if message['reap'] not in self._reaped:
                os.waitpid(message['reap'], 0)
            del self._runs[message['reap']]
        else:
            self._begin(message['run'], message['job'], *descriptors)
        return True

    def _exactly(self, count: int) -> bytes:
        data = b''
        while len(data) < count:
            data += self._control.recv(count - len(data))
        return data

    def _begin(self, number: int, job: dict[str, Any], channel: int, output: int) -> None:
        pid = os.fork()
        if pid == 0:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            self._control.close()
            os.close(self._wake)
            os.close(self._wake_end)
            self._child.run(job, channel, output)
            os._exit(0)
        os.close(channel)
        os.close(output)
        self._runs[pid] = number
        self._say({'run': number, 'pid': pid})

    def _tell_who_ended(self) -> None:
        """Tell of every run that has ended, once, without letting the system forget it."""
        for pid, number in self._runs.items():
            if number in self._told:
                continue
            status = self._status(pid)
            if status is not None:
                self._told.add(number)
                self._say({'run': number, 'status': status})

    def _status(self, pid: int) -> int | None:
        """How a process ended, negative for a signal; None while it runs. Where the system can, it stays to be reaped."""
        if hasattr(os, 'waitid'):
            ended = os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT)
            if ended is None:
                return None
            return ended.si_status if ended.si_code == os.CLD_EXITED else -ended.si_status
        found, status = os.waitpid(pid, os.WNOHANG)
        if not found:
            return None
        self._reaped.add(pid)
        return os.waitstatus_to_exitcode(status)

    def _say(self, message: dict[str, int]) -> None:
        data = json.dumps(message).encode()
        self._control.sendall(len(data).to_bytes(LENGTH_BYTES, 'big') + data)


if __name__ == '__main__':
    main()

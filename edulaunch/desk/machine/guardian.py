"""The process that watches a machine from outside. It reports where the machine is stuck, and can kill it.

A program that keeps Python's interpreter inside one call of C code (`sum(range(10**12))`) stops every thread of the machine.
The guardian is the machine's parent process and receives heartbeats from it. When the heartbeats stop, the guardian writes
the state of the machine to a file that the terminals read. The guardian uses only the standard library, so it needs only a
few megabytes.

The command line is `python -m edulaunch.desk.machine.guardian FOLDER DOMAIN PID`. File descriptor 3 is the pipe for the
heartbeats.
"""

from __future__ import annotations

import os
import select
import signal
import sys
import time
from sysconfig import get_path
from types import FrameType

from edulaunch.desk.machine.place import (
    BEATS,
    BUSY_SIGN,
    IDLE_SIGN,
    busy_file,
    locked,
    log_file,
    read_address,
    remove_address,
    seconds_from,
)
from edulaunch.runtime.interrupt_watcher import innermost_own

LOOK_S = 0.25
SLOW_S = 1.0
"""If a program has not yielded for this many seconds, the guardian reports the state to the terminals."""
TURN_LIMIT_S = 2.0
INTERRUPT, END = 5, 8
"""Python may be silent for this many times the limit before the program is interrupted, and before the machine is killed."""
BUSY_INTERRUPT, BUSY_END = 12, 30
"""The same limits while Python still runs. In this case, the watchdog inside the machine acts first."""
STOP_S = 1.0
"""A machine has this many seconds to end by itself when a user stops it."""
ENGINE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))) + os.sep
LIBRARIES = (
    ENGINE,
    *(os.path.join(path, '') for path in (os.path.dirname(os.__file__), *map(get_path, ('stdlib', 'purelib', 'platlib')))),
)
"""A copy of the list in `frame_owner`; importing that module would load the engine, and this process should stay small."""
HEADER = '(most recent call first):'


class Guardian:
    """Watches one machine.

    :param place: the folder of the machines.
    :param number: the ROS_DOMAIN_ID of the machine.
    :param pid: the process id of the machine, which is a child of this process.
    :param pipe: the file descriptor from which the heartbeats are read.
    :param limit_s: the processor time in seconds that one program may use without yielding.
    """

    def __init__(self, place: str, number: str, pid: int, pipe: int, limit_s: float) -> None:
        self._place, self._number = place, number
        self._pid, self._pipe, self._limit_s = pid, pipe, limit_s
        self._is_stopped = False
        self._stop_at_s: float | None = None
        self._why = ''
        self._turn_s = self._beat_s = self._looked_s = time.monotonic()
        self._silent_s = 0.0
        self._processor_s = _processor_s(pid)
        self._interrupted = self._ended = False
        self._reported_at_s = 0.0
        self._where = self._traceback = ''
        self.is_ready = False

    def stop(self, signum: int = 0, frame: FrameType | None = None) -> None:
        """Stop the machine because a user asks for it. The machine first gets a moment to end by itself."""
        if self._stop_at_s is None:
            self._stop_at_s = time.monotonic() + STOP_S
            self._signal(signal.SIGTERM)

    def run(self) -> int:
        """Watch the machine until it ends. Return its exit code, which is negative if a signal ended it."""
        while True:
            if self._pipe >= 0 and select.select([self._pipe], [], [], LOOK_S)[0]:
                self._hear()
            elif self._pipe < 0:
                time.sleep(LOOK_S)
            code = self._reap()
            if code is not None:
                return code
            self._judge()

    def _reap(self) -> int | None:
        pid, status = os.waitpid(self._pid, os.WNOHANG | os.WUNTRACED | os.WCONTINUED)
        if not pid:
            return None
        if os.WIFSTOPPED(status) or os.WIFCONTINUED(status):
            self._is_stopped = os.WIFSTOPPED(status)
            return None
        return os.waitstatus_to_exitcode(status)

    def _hear(self) -> None:
        data = os.read(self._pipe, 1 << 16)
        if not data:
            os.close(self._pipe)
            self._pipe = -1
        text = data.decode('utf-8', 'replace')
        now_s = time.monotonic()
        self._traceback = ''.join((self._traceback + text).rpartition(HEADER)[1:])  # the traceback arrives in pieces
        if self._traceback.startswith(HEADER):
            self._where = innermost_own(self._traceback, LIBRARIES) or self._where
        if BUSY_SIGN in text or IDLE_SIGN in text:
            self.is_ready = True
            self._beat_s, self._silent_s, self._ended = now_s, 0.0, False
        if IDLE_SIGN in text:
            self._turn_s, self._interrupted, self._where = now_s, False, ''
            if self._reported_at_s:
                self._reported_at_s = 0.0
                _remove(busy_file(self._place, self._number))

    def _judge(self) -> None:
        """Report where the machine is stuck, interrupt it, or kill it, depending on how long it has been stuck."""
        now_s = time.monotonic()
        passed_s, self._looked_s = now_s - self._looked_s, now_s
        processor_s = _processor_s(self._pid)
        used_s, self._processor_s = processor_s - self._processor_s, processor_s
        if self._stop_at_s is not None and now_s > self._stop_at_s:
            self._end('The machine did not answer `edulaunch machine stop`, so it was killed.')
            return
        if not self.is_ready:
            return
        if self._is_stopped:
            self._tell(now_s, _stopped(self._pid))
            return
        if now_s - self._beat_s > 2 * LOOK_S:  # a busy or sleeping computer is not a reason to kill a machine
            self._silent_s += used_s if processor_s else passed_s
        busy_s = now_s - self._turn_s
        if busy_s < SLOW_S:
            return
        if now_s - self._reported_at_s >= SLOW_S:
            self._signal(signal.SIGUSR1)  # the machine answers with the line of the program, also during C code
        self._tell(now_s, self._busy(busy_s))
        silent, busy = self._silent_s / self._limit_s, busy_s / self._limit_s
        if not self._interrupted and (silent > INTERRUPT or busy > BUSY_INTERRUPT):
            self._interrupted = True
            self._signal(signal.SIGUSR2)
        elif silent > END or (self._interrupted and busy > BUSY_END):
            where = self._where or 'a program'
            self._end(f'{where} ran for {busy_s:.0f} s without a pause, could not be interrupted, and ended with the machine.')

    def _busy(self, busy_s: float) -> str:
        text = f'{self._where or "a program"} has run for {busy_s:.0f} s without a pause, and no other program can run'
        most = END if self._silent_s else BUSY_END
        end = f'it ends by itself after about {most * self._limit_s:.0f} s of processor time'
        return f'{text}\n  help: `edulaunch machine stop` ends the machine at once; {end}'

    def _tell(self, now_s: float, text: str) -> None:
        if now_s - self._reported_at_s >= SLOW_S:
            self._reported_at_s = now_s
            path = busy_file(self._place, self._number)
            with open(os.open(f'{path}.new', os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), 'w', encoding='utf-8') as file:
                file.write(f'{self._pid}\n{text}\n')
            os.replace(f'{path}.new', path)

    def _end(self, why: str) -> None:
        if not self._ended:
            self._ended = True
            self._why = why
            _complain(self._place, self._number, f'{why}\n  All programs on it have ended.')
            self._signal(signal.SIGCONT)
            self._signal(signal.SIGKILL)

    def _signal(self, signum: int) -> None:
        try:
            os.kill(self._pid, signum)
        except ProcessLookupError:
            return

    def clean_up(self, code: int) -> None:
        """Remove the file with the address of an ended machine.

        Write the reason for the end to the log if it is not there yet.
        """
        with locked(self._place, self._number):
            address = read_address(self._place, self._number)
            if address is None or address.pid != self._pid:
                return
            if code < 0 and not self._why and self._stop_at_s is None:
                what = signal.Signals(-code).name if -code in set(signal.Signals) else f'signal {-code}'
                why = f'The process of the machine ({self._pid}) was killed from outside ({what}).'
                _complain(self._place, self._number, why)
            _remove(busy_file(self._place, self._number))
            remove_address(self._place, self._number, address)


def _stopped(pid: int) -> str:
    why = f'the process of the machine ({pid}) was stopped by a signal'
    return f'{why}\n  help: `kill -CONT {pid}` continues it; `edulaunch machine stop` ends it'


def _complain(place: str, number: str, text: str) -> None:
    with open(os.open(log_file(place, number), os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600), 'a', encoding='utf-8') as file:
        file.write(f'{text}\n')


def _remove(path: str) -> None:
    try:
        os.unlink(path)
    except FileNotFoundError:
        return


def _processor_s(pid: int) -> float:
    """Return the processor time in seconds that a process has used. Return 0 if the system does not report it."""
    try:
        with open(f'/proc/{pid}/stat', encoding='ascii', errors='replace') as file:
            fields = file.read().rpartition(')')[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')
    except (OSError, ValueError, IndexError):
        return 0.0


def main() -> None:
    """Run a guardian with the arguments of the command line."""
    place, number, pid = sys.argv[1], sys.argv[2], int(sys.argv[3])
    _remove(busy_file(place, number))
    guardian = Guardian(place, number, pid, BEATS, seconds_from('EDULAUNCH_TURN_LIMIT_S', TURN_LIMIT_S))
    for name in ('SIGINT', 'SIGHUP', 'SIGQUIT'):
        signal.signal(getattr(signal, name), signal.SIG_IGN)
    signal.signal(signal.SIGTERM, guardian.stop)
    guardian.clean_up(guardian.run())


if __name__ == '__main__':
    main()

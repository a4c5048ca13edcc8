"""The keyboard of a client's terminal. Its mode follows the program that reads, and is restored even if the client is killed."""

from __future__ import annotations

import os
import signal

from edulaunch.desk.machine.wire import CANONICAL, ECHO, PLAIN_MODE, SIGNALS


class Keyboard:
    """The standard input of this process.

    :ivar is_terminal: whether standard input is a terminal. If not, a change of the mode has no effect.
    """

    def __init__(self) -> None:
        self.is_terminal = os.isatty(0)
        self._before: list[object] | None = None
        self._lifeline = -1

    def set_mode(self, mode: int) -> None:
        """Change the mode of the terminal as the program requests.

        :param mode: flags for whole lines or single keys, for echo, and for Ctrl-C as a signal.
        """
        if not self.is_terminal or (mode == PLAIN_MODE and self._before is None):
            return
        import termios

        if self._before is None:
            self._before = termios.tcgetattr(0)
            self._lifeline = _restore_when_we_die(self._before)
        now = list(self._before)
        now[3] = int(now[3])  # type: ignore[call-overload]
        for sign, flag in ((CANONICAL, termios.ICANON), (ECHO, termios.ECHO), (SIGNALS, termios.ISIG)):
            if not mode & sign:
                now[3] &= ~flag  # type: ignore[operator]
        termios.tcsetattr(0, termios.TCSADRAIN, now)  # type: ignore[arg-type]

    def restore(self) -> None:
        """Restore the mode that the terminal had at first."""
        if self._before is not None:
            import termios

            termios.tcsetattr(0, termios.TCSADRAIN, self._before)  # type: ignore[arg-type]
            os.write(self._lifeline, b'.')
            os.close(self._lifeline)
            self._before = None


def _restore_when_we_die(before: list[object]) -> int:
    """Start a process that restores the terminal if this process ends without cleaning up, as after SIGKILL.

    The new process has its own session, so it survives when the terminal's programs are killed together.

    :return: a file descriptor. When this process writes a byte to it, the new process ends.
    """
    import termios

    reader, writer = os.pipe()
    ready, is_ready = os.pipe()
    if os.fork() == 0:
        try:
            os.setsid()
            for signum in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
                signal.signal(signum, signal.SIG_IGN)
            os.closerange(1, reader)
            os.closerange(reader + 1, is_ready)
            os.closerange(is_ready + 1, 256)
            os.write(is_ready, b'.')
            os.close(is_ready)
            if not os.read(reader, 1):
                termios.tcsetattr(0, termios.TCSADRAIN, before)  # type: ignore[arg-type]
        finally:
            os._exit(0)
    for number in (reader, is_ready):
        os.close(number)
    os.read(ready, 1)  # wait until it is ready: an earlier signal would end the restoring process, too
    os.close(ready)
    return writer

"""`ros2 run`, `ros2 launch` and `ros2 component standalone` of a `--real` program. The programs that they start are real, too.

The command line is `python -m edulaunch.extras.network.real_command LOCK WORDS...`. LOCK is a file that is locked while the
launch runs, and WORDS are the words after `ros2`.
"""

from __future__ import annotations

import signal
import sys
from collections.abc import Sequence
from typing import Any

from edulaunch.desk.cli.launch import InterruptHandler
from edulaunch.engine.packages.discovery import workspaces_of_command
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native.ending import end_with
from edulaunch.extras.network.native_session import NativeSession
from edulaunch.runtime.session import Session


class Command:
    """A command in place of a launch. It receives Ctrl-C, and the session ends when the command ends."""

    def __init__(self, session: Session, words: Sequence[str]) -> None:
        spec = ProcessSpec(argv=('ros2', *words), name='ros2', env=dict(session.host.env))
        self._process = session.host.start(spec, _write)

    @property
    def is_over(self) -> bool:
        """Return whether the command has ended."""
        return self._process.returncode is not None

    def interrupt(self) -> None:
        """Interrupt the command as Ctrl-C does."""
        self._process.send_signal(signal.SIGINT)

    @property
    def code(self) -> int:
        """Return the exit code of the command."""
        return self._process.returncode or 0


def _write(stream: str, text: str) -> None:
    place = getattr(sys, stream)
    place.write(text)
    place.flush()


def main() -> int:
    """Run the command until it ends."""
    lock, *words = sys.argv[1:]
    end_with(lock)
    with NativeSession(workspaces=workspaces_of_command((), words[1] if len(words) > 1 else '')) as session:
        command: Any = Command(session, words)
        session.launches.append(command)
        InterruptHandler(session, None).run(1.0)
    return int(command.code)


if __name__ == '__main__':
    sys.exit(main())

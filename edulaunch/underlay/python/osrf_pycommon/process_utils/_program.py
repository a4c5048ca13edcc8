"""What to start for the arguments that all functions here have."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os.path import basename
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.process import Process
    from edulaunch.processes.spec import ProcessSpec

Command = str | Sequence[str]


def program(process: Process, cmd: Command, cwd: str | None, env: Mapping[str, str] | None, shell: bool) -> ProcessSpec:
    """The program of a command line: words, or one text for a shell; a text without a shell is the program's name."""
    from edulaunch.processes.spec import ProcessSpec

    words = (cmd,) if isinstance(cmd, str) else tuple(cmd)
    return ProcessSpec(
        argv=words, name=basename(words[0].split()[0]), cwd=cwd, env=dict(process.env if env is None else env), shell=shell
    )

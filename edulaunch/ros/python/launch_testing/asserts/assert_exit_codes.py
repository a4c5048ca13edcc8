"""Assertions about the exit codes of processes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..util.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
from ..util.proc_lookup import CmdArgs, resolveProcesses

if TYPE_CHECKING:
    from ..proc_info_handler import ProcInfoHandler


EXIT_OK = 0


EXIT_SIGINT = 130


EXIT_SIGQUIT = 131


EXIT_SIGKILL = 137


EXIT_SIGSEGV = 139


def assertExitCodes(
    proc_info: ProcInfoHandler,
    allowable_exit_codes: Sequence[int] = (EXIT_OK,),
    process: Any = None,
    cmd_args: CmdArgs = None,
    *,
    strict_proc_matching: bool = True,
) -> None:
    """Assert that a process, or every process, has ended with one of these codes.

    A process that was ended by SIGINT has the return code -2. This is not EXIT_SIGINT, the exit code 130 that a shell reports.

    :param process: an action, or part of a launch name; None means all processes.
    :raises AssertionError: when a process has ended with another code. The message names the first such process.
    :raises TypeError: for an allowed code that is not a number.
    """
    for code in allowable_exit_codes:
        if not isinstance(code, int):
            raise TypeError(f'allowable_exit_codes must contain integers, got {code!r}')
    actions = (
        proc_info.processes()
        if process is None
        else resolveProcesses(proc_info, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    )
    for info in [proc_info[action] for action in actions]:
        returncode: int | None = getattr(info, 'returncode', None)
        if returncode is None:
            raise AssertionError(f'Proc {info.process_name} has not ended: it has no exit code yet')
        if returncode not in allowable_exit_codes:
            raise AssertionError(f'Proc {info.process_name} exited with code {returncode}')

"""Finds the processes of a launch test."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol

from launch.actions.execute_local import ExecuteLocal


class _NoCmdArgs:
    def __repr__(self) -> str:
        return 'NO_CMD_ARGS'


NO_CMD_ARGS = _NoCmdArgs()
"""A value of `cmd_args` that selects only processes without arguments."""


CmdArgs = str | Sequence[str] | _NoCmdArgs | None


class HasProcesses(Protocol):
    """An object with records of processes."""

    def processes(self) -> Iterable[Any]:
        """Return the actions of the processes that have been recorded."""


class NoMatchingProcessException(Exception):
    """There is no record of a matching process."""


def process_name(action: ExecuteLocal) -> str:
    """Return the launch name of the process, such as 'talker-1'."""
    details = action.process_details
    return str(details['name']) if details is not None else type(action).__name__


def _name_and_arguments(action: ExecuteLocal) -> str:
    words = list(action.process_details['cmd'])[1:] if action.process_details is not None else []
    return ' '.join([process_name(action), *words])


def resolveProcesses(
    info_obj: HasProcesses, *, process: Any = None, cmd_args: CmdArgs = None, strict_proc_matching: bool = True
) -> list[Any]:
    """Return the actions of the processes that `process` names.

    :param process: an action, or part of a launch name; None means all processes.
    :param cmd_args: arguments that a process with this name must have: a string, a list of strings, or NO_CMD_ARGS.
    :param strict_proc_matching: whether to reject a name that matches several processes.
    :raises NoMatchingProcessException: for an unknown process. The methods of launch_testing that wait for a process
        continue to wait.
    :raises ValueError: when several processes match and `strict_proc_matching` is set.
    :raises TypeError: for any other type of `process`.
    """
    known = list(info_obj.processes())
    if process is None:
        if not known:
            raise NoMatchingProcessException('No data recorded for any process')
        return known
    if isinstance(process, ExecuteLocal):
        if process in known:
            return [process]
        raise NoMatchingProcessException(f'No data recorded for proc {_name_and_arguments(process)}')
    if not isinstance(process, str):
        raise TypeError(f"proc argument must be 'ExecuteProcess' or 'str' not {type(process)}")
    matching = [action for action in known if process in process_name(action) and _has_arguments(action, cmd_args)]
    names = ', '.join(sorted(map(_name_and_arguments, matching or known)))
    if not matching:
        raise NoMatchingProcessException(
            f"Did not find any processes matching name '{process}' and args '{cmd_args}'. Procs: {names}"
        )
    if strict_proc_matching and len(matching) > 1:
        raise ValueError(f"Found multiple processes matching name '{process}' and cmd_args '{cmd_args}'. Procs: {names}")
    return matching


def _has_arguments(action: ExecuteLocal, wanted: CmdArgs) -> bool:
    assert action.process_details is not None
    arguments = list(action.process_details['cmd'])[1:]
    if wanted is None:
        return True
    if isinstance(wanted, _NoCmdArgs):
        return not arguments
    if isinstance(wanted, str):
        return wanted in arguments
    return all(argument in arguments for argument in wanted)

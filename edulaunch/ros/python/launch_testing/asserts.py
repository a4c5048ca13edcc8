"""Assertions about what processes printed and how they ended."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from launch._lazy import has_ros_paths

from .tools import build_text_match
from .util import NO_CMD_ARGS as NO_CMD_ARGS
from .util import CmdArgs, process_name, resolveProcesses

if TYPE_CHECKING:
    from .io_handler import IoHandler, ProcInfoHandler

STREAMS = ('stdout', 'stderr')


def assertInStream(
    proc_output: IoHandler,
    expected_output: Any,
    process: Any = None,
    cmd_args: CmdArgs = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
    stream: str = 'stderr',
) -> None:
    """Claim that a process has written something to a stream.

    :param expected_output: a text, a compiled regular expression, or a list of them in this order.
    :param process: an action, or part of a launch name; None: any process.
    :param output_filter: changes what was written before it is compared.
    :param strip_ansi_escape_sequences: compare without colours.
    :raises AssertionError: when it has not.
    :raises ValueError: for a stream that is neither 'stdout' nor 'stderr'.
    """
    matches = build_text_match(expected_output, strip_ansi_escape_sequences=strip_ansi_escape_sequences)
    actions = resolveProcesses(
        proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching and process is not None
    )
    for action in actions:
        text = text_of(proc_output, action, stream)
        if matches(text if output_filter is None else output_filter(text)) is not None:
            return
    names = ', '.join(sorted(map(process_name, actions)))
    raise AssertionError(f"Did not find '{_shown(expected_output)}' in output for any of the matching processes: {names}")


def assertInStdout(proc_output: IoHandler, expected_output: Any, process: Any, cmd_args: CmdArgs = None, **options: Any) -> None:
    """As :func:`assertInStream`, for the standard output.

    :param options: its `output_filter`, `strict_proc_matching` and `strip_ansi_escape_sequences`.
    """
    assertInStream(proc_output, expected_output, process, cmd_args, stream='stdout', **options)


def assertInStderr(proc_output: IoHandler, expected_output: Any, process: Any, cmd_args: CmdArgs = None, **options: Any) -> None:
    """As :func:`assertInStdout`, for the standard error, where nodes log."""
    assertInStream(proc_output, expected_output, process, cmd_args, stream='stderr', **options)


def text_of(proc_output: IoHandler, action: Any, stream: str) -> str:
    """Everything that a process has written to 'stdout' or 'stderr'."""
    if stream not in STREAMS:
        raise ValueError(f"stream must be 'stdout' or 'stderr', got {stream!r}")
    wanted = stream == 'stdout'
    pieces = [piece.text for piece in proc_output[action] if piece.from_stdout == wanted and not piece.from_stdin]
    return b''.join(pieces).decode(errors='replace')


def _shown(expected: Any) -> Any:
    return getattr(expected, 'pattern', expected)


class SequentialTextChecker:
    """Looks for texts behind those that were found before.

    :param text: everything that was written, perhaps in pieces.
    """

    def __init__(self, text: str | Iterable[str]) -> None:
        self._text = text if isinstance(text, str) else ''.join(text)
        self._position = 0

    def assertInStdout(self, msg: Any) -> None:
        """Claim that `msg` (a text or a compiled regular expression) comes after what was found before.

        :raises AssertionError: when it does not.
        """
        match = build_text_match(msg)
        found = match(self._text, self._position)
        if found is None:
            where = 'at all' if match(self._text) is None else 'there, only before it'
            raise AssertionError(
                f"'{_shown(msg)}' was not found in the output after character "
                f'{self._position}\n  help: it was not written {where}'
            )
        self._position = found[1]


@contextmanager
def assertSequentialStdout(proc_output: IoHandler, process: Any, cmd_args: CmdArgs = None) -> Iterator[SequentialTextChecker]:
    """Check the standard output of one process in order: `with assertSequentialStdout(...) as c: c.assertInStdout('a')`."""
    (action,) = resolveProcesses(proc_output, process=process, cmd_args=cmd_args)
    yield SequentialTextChecker(text_of(proc_output, action, 'stdout'))


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
    """Claim that a process, or every one, ended with one of these codes.

    A process that SIGINT ended has the return code -2, which is not EXIT_SIGINT (130, what a shell makes of it).

    :param process: an action, or part of a launch name; None: all processes.
    :raises AssertionError: naming the first that ended otherwise.
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


__all__ = ['NO_CMD_ARGS']
has_ros_paths(
    __name__,
    'EXIT_OK=assert_exit_codes EXIT_SIGINT=assert_exit_codes EXIT_SIGKILL=assert_exit_codes EXIT_SIGQUIT=assert_exit_codes '
    'EXIT_SIGSEGV=assert_exit_codes assertExitCodes SequentialTextChecker=assert_sequential_output '
    'assertSequentialStdout=assert_sequential_output assertInStderr=assert_output assertInStdout=assert_output '
    'assertInStream=assert_output',
)

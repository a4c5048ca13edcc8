"""Assertions about the output of processes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..tools.text import build_text_match
from ..util.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
from ..util.proc_lookup import CmdArgs, process_name, resolveProcesses

if TYPE_CHECKING:
    from ..io_handler import IoHandler


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
    """Assert that a process has written the expected output to a stream.

    :param expected_output: a string, a compiled regular expression, or a list of them in order.
    :param process: an action, or part of a launch name; None means any process.
    :param output_filter: a function that changes the output before the comparison.
    :param strip_ansi_escape_sequences: whether to remove colours before the comparison.
    :raises AssertionError: when the output is not found.
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
    """Assert that a process has written the expected output to its standard output; see :func:`assertInStream`.

    :param options: `output_filter`, `strict_proc_matching` and `strip_ansi_escape_sequences` of :func:`assertInStream`.
    """
    assertInStream(proc_output, expected_output, process, cmd_args, stream='stdout', **options)


def assertInStderr(proc_output: IoHandler, expected_output: Any, process: Any, cmd_args: CmdArgs = None, **options: Any) -> None:
    """Assert that a process has written the expected output to its standard error, where nodes log; see
    :func:`assertInStream`.
    """
    assertInStream(proc_output, expected_output, process, cmd_args, stream='stderr', **options)


def text_of(proc_output: IoHandler, action: Any, stream: str) -> str:
    """Return everything that a process has written to 'stdout' or 'stderr'."""
    if stream not in STREAMS:
        raise ValueError(f"stream must be 'stdout' or 'stderr', got {stream!r}")
    wanted = stream == 'stdout'
    pieces = [piece.text for piece in proc_output[action] if piece.from_stdout == wanted and not piece.from_stdin]
    return b''.join(pieces).decode(errors='replace')


def _shown(expected: Any) -> Any:
    return getattr(expected, 'pattern', expected)

"""Assertions about the order of a process's output."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ..tools.text import build_text_match
from ..util.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
from ..util.proc_lookup import CmdArgs, resolveProcesses
from .assert_output import _shown, text_of

if TYPE_CHECKING:
    from ..io_handler import IoHandler


class SequentialTextChecker:
    """Searches for each string after the previous match.

    :param text: all output, as one string or a list of strings.
    """

    def __init__(self, text: str | Iterable[str]) -> None:
        self._text = text if isinstance(text, str) else ''.join(text)
        self._position = 0

    def assertInStdout(self, msg: Any) -> None:
        """Assert that `msg` (a string or a compiled regular expression) comes after the previous match.

        :raises AssertionError: when `msg` does not come after the previous match.
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

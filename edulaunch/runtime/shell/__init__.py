"""The shell of the simulated machine: it runs lines that name simulated programs in simulated time.

A real shell cannot reach these programs. A host has a :class:`SimulatedShell`. Start reading in `grammar`, and then read `lines`.

`grammar` and `lines` are imported on first use, because few launch files have a shell line, and importing both takes 16 ms.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import partial

from edulaunch.engine.processes.commands import Main
from edulaunch.runtime.shell.signs import SHELLS, SIGNS


class SimulatedShell:
    """Parses and runs shell lines; see :class:`edulaunch.engine.processes.commands.Shell`."""

    def needs_shell(self, line: str) -> bool:
        """Return whether the line contains a shell character outside quotation marks."""
        return bool(SIGNS & set(_outside_quotes(line)))

    def script_of(self, words: Sequence[str]) -> Sequence[str] | None:
        """Return the line after the `-c` of a shell. Return None for any other command."""
        is_shell = os.path.basename(words[0]) in SHELLS and words[1:2] == ['-c']
        return words[2:] if is_shell else None

    def main_of(self, line: str, arguments: Sequence[str], knows: Callable[[Sequence[str]], bool]) -> Main | None:
        """Return a function that runs the line. Return None if the line cannot be parsed or contains no simulated command."""
        from edulaunch.runtime.shell.grammar import parsed
        from edulaunch.runtime.shell.lines import is_simulated, run_line

        return partial(run_line, text=line) if is_simulated(parsed(line), arguments, knows) else None


def _outside_quotes(line: str) -> str:
    """Return the characters of a shell line outside quotation marks."""
    kept, quote = [], ''
    for character in line:
        if quote:
            quote = '' if character == quote else quote
        elif character in '"\'':
            quote = character
        else:
            kept.append(character)
    return ''.join(kept)

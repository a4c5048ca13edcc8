"""A student at a lesson: runs cells as Jupyter does, magics and all, in any order, changed, twice, after a restart.

An IPython of its own in this process takes the place of a kernel: the same magics, the same shape of errors, in a tenth of the time.
"""

from __future__ import annotations

import atexit
import io
import os
import re
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from tests.lessons.notebook import LESSONS, Lesson

COLOURS = re.compile(r'\x1b\[[0-9;]*m')


class Student:
    """Somebody who works through a lesson in a folder of their own."""

    def __init__(self, lesson: str, folder: Path) -> None:
        self.lesson = Lesson(lesson)
        self.folder = folder / 'lessons'
        self.folder.mkdir()
        for part in ('checkpoints', 'checks'):
            shutil.copytree(LESSONS / part, self.folder / part)
        shutil.copy(LESSONS.parent / 'solutions' / 'questions.toml', self.folder)
        shutil.copytree(LESSONS.parent / 'exercises', folder / 'exercises')
        self.restart()

    def restart(self) -> None:
        """*Restart Kernel*: the files stay, the names are gone."""
        from IPython.core.interactiveshell import InteractiveShell
        from traitlets.config import Config

        leave()
        make: Any = InteractiveShell
        # A history would be a thread of each shell that never ends: with two hundred of them everything else takes seven times as long.
        quiet = Config(HistoryManager={'enabled': False})
        self.shell: Any = make.instance(config=quiet, history_load_length=0, cache_size=0)

    def run(self, ident: str, edits: Mapping[str, Any]) -> str:
        """Run one cell, changed or as it is; returns all that stands below it.

        :param edits: by cell, its whole new text, or pairs (old, new); a cell that is not there is one that the student has added.
        """
        change = edits.get(ident, ())
        source = change if isinstance(change, str) else self.lesson[ident].source
        for old, new in change if not isinstance(change, str) else ():
            assert source.count(old), f'{ident} has no {old!r}'
            source = source.replace(old, new)
        told = io.StringIO()
        with _in(self.folder), redirect_stdout(told), redirect_stderr(told):
            self.shell.run_cell(source, store_history=False)
        return COLOURS.sub('', told.getvalue())

    def walk(self, cells: str, edits: Mapping[str, Any]) -> str:
        """Run cells by their names, in this order; `restart` is one. Returns what the last one told."""
        told, words = '', cells.split()
        for number, word in enumerate(words, 1):
            if word == 'restart':
                self.restart()
            else:
                self.shell.display_formatter.mimebundle_formatter.enabled = number == len(words)  # a picture that nobody sees is not drawn
                told = self.run(word, edits)
        return told


def leave() -> None:
    """End the IPython that is there, if any, with the machine of its magics, and forget all that its cells made: at exit IPython would
    look at each shell once more, and until then keeps them with their recordings.
    """
    made: Any = sys.modules.get('IPython.core.interactiveshell')
    shell = made and made.InteractiveShell._instance
    if shell:
        for magics in shell.magics_manager.registry.values():
            session = magics.terminal.machine.session if hasattr(magics, 'terminal') else None
            if session is not None:
                session.close()  # else its watchdog looks at all threads, many times a second
        atexit.unregister(shell.atexit_operations)
        shell.restore_sys_module_state()  # other tests need a `__main__` with a name
        shell.user_ns.clear()
        made.InteractiveShell.clear_instance()


@contextmanager
def _in(folder: Path) -> Iterator[None]:
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)

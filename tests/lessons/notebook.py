"""A lesson as data, and walking through it as a student does, without a kernel."""

from __future__ import annotations

import ast
import contextlib
import io
import json
import re
from pathlib import Path
from typing import Any, NamedTuple

LESSONS = Path(__file__).resolve().parents[2] / 'lessons'
WRITES = '%%writefile '
ORDER = [
    '00_python',
    '01_first_launch',
    '02_names',
    '03_parameters',
    '04_conditions',
    '05_events',
    '06_xml_yaml',
    '07_packages',
    '08_static_broadcaster',
    '09_broadcaster_and_listener',
    '10_carrots',
    '11_time',
    '12_urdf',
    '13_large_project',
    '14_services',
    '15_bags',
    '16_silent_systems',
    '17_fleet',
    '18_real_network',
]


class Cell(NamedTuple):
    """One cell; `outputs` are those that are kept beside the lesson."""

    id: str
    kind: str
    source: str
    tags: list[str]
    outputs: list[dict[str, Any]]

    @property
    def lines(self) -> list[str]:
        """The lines of its source."""
        return self.source.split('\n')

    @property
    def text(self) -> str:
        """What its outputs say in plain text."""
        return '\n'.join(
            ''.join(output.get('text', '') or output.get('data', {}).get('text/plain', '')) for output in self.outputs
        )

    @property
    def file(self) -> tuple[str, str] | None:
        """The path and the text of the file that the cell writes; None when it writes none."""
        if not self.source.startswith(WRITES):
            return None
        first, _, rest = self.source.partition('\n')
        return first[len(WRITES) :].strip(), rest + '\n'


class Lesson:
    """One notebook as it is stored."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.raw: dict[str, Any] = json.loads((LESSONS / f'{name}.ipynb').read_text(encoding='utf-8'))
        self.kept: dict[str, Any] = json.loads((LESSONS / '.outputs' / f'{name}.json').read_text(encoding='utf-8'))
        self.cells = [_cell(row, self.kept) for row in self.raw['cells']]

    @property
    def code(self) -> list[Cell]:
        """The code cells."""
        return [cell for cell in self.cells if cell.kind == 'code']

    @property
    def prose(self) -> str:
        """All text cells, one after the other."""
        return '\n\n'.join(cell.source for cell in self.cells if cell.kind == 'markdown')

    def files(self) -> dict[str, str]:
        """The files that the lesson writes, as they are at its end."""
        return dict(cell.file for cell in self.code if cell.file is not None)

    def __getitem__(self, ident: str) -> Cell:
        return next(cell for cell in self.cells if cell.id == ident)


class Walk:
    """A student in a folder: runs cells in any order, and changes files. Magics are left out; `_` is what a cell shows."""

    def __init__(self, lesson: Lesson, folder: Path) -> None:
        self.lesson = lesson
        self.folder = folder
        self.names: dict[str, Any] = {}

    def run(self, ident: str) -> str:
        """Run one cell in the folder; returns what it printed."""
        cell = self.lesson[ident]
        if cell.file is not None:
            self.write(*cell.file)
            return ''
        tree = ast.parse(re.sub(r'(?m)^%.*$', '', cell.source))
        if tree.body and isinstance(tree.body[-1], ast.Expr):  # what a notebook shows
            tree.body[-1] = ast.Assign([ast.Name('_', ast.Store())], tree.body[-1].value)
        told = io.StringIO()
        with (
            contextlib.chdir(self.folder) if hasattr(contextlib, 'chdir') else _chdir(self.folder),
            contextlib.redirect_stdout(told),
        ):
            exec(compile(ast.fix_missing_locations(tree), f'<cell {ident}>', 'exec'), self.names)
        return told.getvalue()

    def run_all(self, *, until: str) -> None:
        """Run the set-up, and every cell that writes a file, up to a cell."""
        for cell in self.lesson.code:
            if cell.id == until:
                return
            if cell.file is not None or cell.id in ('set-up', 'folders'):
                self.run(cell.id)

    def write(self, path: str, text: str) -> None:
        """Write a file as %%writefile does."""
        (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / path).write_text(text, encoding='utf-8')

    def edit(self, path: str, old: str, new: str) -> None:
        """Change one place in a file."""
        text = (self.folder / path).read_text(encoding='utf-8')
        assert text.count(old) == 1, f'{old!r} is {text.count(old)} times in {path}'
        self.write(path, text.replace(old, new))


def _cell(row: dict[str, Any], kept: dict[str, Any]) -> Cell:
    return Cell(row['id'], row['cell_type'], ''.join(row['source']), row['metadata'].get('tags', []), kept.get(row['id'], []))


@contextlib.contextmanager
def _chdir(folder: Path) -> Any:
    """`contextlib.chdir`, which Python 3.10 lacks."""
    import os

    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)

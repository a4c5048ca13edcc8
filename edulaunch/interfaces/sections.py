"""Lines of an interface file, and its parts between the `---`."""

from __future__ import annotations

import re
from typing import NamedTuple, NoReturn

from edulaunch.errors import InterfaceError


class Line(NamedTuple):
    """One line without its comment."""

    file: str
    number: int
    text: str

    def fail(self, message: str, help: str | None = None) -> NoReturn:
        """Raise an InterfaceError that names the file and the line."""
        raise InterfaceError(f'{self.file}:{self.number}: {message}', help=help)


def sections_of(text: str, file: str, kind: str, wanted: int) -> list[list[Line]]:
    """The lines between the `---`, without comments and blanks."""
    sections: list[list[Line]] = [[]]
    number = 0
    for number, raw in enumerate(re.split('\r\n|\r|\n', text.removeprefix('\ufeff')), 1):
        line = Line(file, number, raw.partition('#')[0].replace('\t', ' ').strip())
        if line.text.startswith('---'):
            if line.text != '---':
                line.fail(f"expected '---' alone on its line, not '{line.text}'")
            sections.append([])
            if len(sections) > wanted:
                lines = f'{wanted - 1 or "no"} line{"s" * (wanted > 2)}'
                line.fail(f"a .{kind} file has {lines} with '---'; this is one too many")
        elif line.text:
            sections[-1].append(line)
    if len(sections) < wanted:
        names = {2: 'request --- response', 3: 'goal --- result --- feedback'}[wanted]
        Line(file, number, '').fail(
            f"expected {wanted - len(sections)} more line{'s' * (wanted - len(sections) > 1)} with '---'",
            help=f'a .{kind} file is: {names}; a part may be empty',
        )
    return sections

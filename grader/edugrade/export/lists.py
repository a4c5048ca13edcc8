"""The lists that platforms give out to be filled in, as CSV."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Sequence

from edulaunch.errors import UnusableInput

from ..regular_file import read_regular
from .marks import Mark

LARGEST_BYTES = 20_000_000


def read_list(path: str) -> tuple[list[str], list[dict[str, str]]]:
    """Head and rows.

    :raises UnusableInput: when it cannot be read.
    """
    try:
        text = read_regular(path, LARGEST_BYTES).decode('utf-8-sig')
    except (OSError, UnicodeDecodeError) as error:
        raise UnusableInput(f'the list {path} cannot be read: {error}', help='it is CSV in UTF-8') from None
    reader = csv.DictReader(io.StringIO(text), restval='')
    rows = [{key: value for key, value in row.items() if isinstance(key, str)} for row in reader]
    return list(reader.fieldnames or ()), rows


def list_text(head: Sequence[str], rows: Sequence[dict[str, str]]) -> str:
    """The list as it was, but for what was filled in."""
    file = io.StringIO()
    writer = csv.DictWriter(file, head, lineterminator='\r\n', extrasaction='ignore')
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue()


def points(mark: Mark) -> str:
    """The mark as a number, or nothing."""
    return '' if mark.earned is None else f'{mark.earned:g}'


class People:
    """Finds the mark of somebody: by a number, else by a name that only one has ('Lovelace, Ada' is 'Ada Lovelace')."""

    def __init__(self, marks: Sequence[Mark]) -> None:
        self._marks = marks
        self._met: set[tuple[str, str]] = set()
        names = Counter(_words(mark.student) for mark in marks)
        self._by_id = {mark.id: mark for mark in marks if mark.id}
        self._by_name = {_words(mark.student): mark for mark in marks if names[_words(mark.student)] == 1}

    def find(self, numbers: Sequence[str], name: str) -> Mark | None:
        """The mark of whoever has one of these numbers, or this name."""
        found = next((self._by_id[number] for number in numbers if number in self._by_id), None)
        if found is None:
            found = self._by_name.get(_words(name))
        if found is not None:
            self._met.add((found.student, found.id))
        return found

    @property
    def unmet(self) -> list[str]:
        """Names of those who have a mark, or should have one, and were not asked for."""
        return [mark.student for mark in self._marks if (mark.student, mark.id) not in self._met]


def _words(name: str) -> str:
    return ' '.join(sorted(name.casefold().replace(',', ' ').split()))

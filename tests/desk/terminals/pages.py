"""Pages of tutorials as data (`pages/*.toml`): what they let one type, in which terminal, and what has to be seen then."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(__file__).parent / 'pages'


class Step(NamedTuple):
    """One command of a page.

    :ivar says: what the page says.
    :ivar type: what is typed here, if that is something else.
    :ivar shows: patterns that the output has in this order.
    :ivar runs: whether it goes on, and its terminal is busy.
    :ivar keys: keys pressed once it shows all that.
    :ivar then: patterns that come after these keys.
    :ivar differs: how it differs from the page; empty: it works word for word.
    :ivar why: why it is not offered; empty: it is.
    :ivar is_pattern: whether the page means a form, with names of the reader's own in place of words.
    :ivar is_ours: whether no page says it: the test looks, or writes what the reader would write.
    """

    says: str
    type: str = ''
    terminal: int = 1
    shows: tuple[str, ...] = ()
    runs: bool = False
    keys: str = ''
    then: tuple[str, ...] = ()
    stop: bool = False
    code: int = 0
    differs: str = ''
    why: str = ''
    is_pattern: bool = False
    is_ours: bool = False

    @property
    def typed(self) -> str:
        """What is typed."""
        return self.type or self.says

    @property
    def verdict(self) -> str:
        """For the table."""
        if self.is_pattern:
            return 'works, with names of your own'
        return f'not offered: {self.why}' if self.why else f'differs: {self.differs}' if self.differs else 'works'


class Page(NamedTuple):
    """A page of a tutorial.

    :ivar group: which of the four groups of tutorials it is in.
    :ivar seed: of the seed tutorials, whose files are copied.
    :ivar copies: what is copied there: from, to.
    :ivar files: small files that the reader has written, by name.
    """

    title: str
    steps: tuple[Step, ...]
    group: str
    seed: str = ''
    copies: tuple[tuple[str, str], ...] = ()
    files: tuple[tuple[str, str], ...] = ()


def pages() -> Iterator[Page]:
    """All pages, in order of the files."""
    for path in sorted(FOLDER.glob('*.toml')):
        for data in tomllib.loads(path.read_text(encoding='utf-8'))['page']:
            yield Page(
                data['title'],
                tuple(map(_step, data['step'])),
                path.stem.partition('_')[2],
                data.get('seed', ''),
                tuple(data.get('copies', {}).items()),
                tuple(data.get('files', {}).items()),
            )


def _step(data: dict[str, Any]) -> Step:
    listed = {name: tuple(data[name]) for name in ('shows', 'then') if name in data}
    return Step(**{**data, **listed})

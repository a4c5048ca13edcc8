"""Known differences, from a table in YAML. Reports list them with their reason, and they do not count."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import NamedTuple

from edulaunch.errors import UnusableInput
from edulaunch.extras.comparing.differing import Difference


class Known(NamedTuple):
    """One row of the table. `file`, `kind`, `name`, `simulated` and `real` are patterns as in a shell.

    :ivar file: the words of the comparison, separated by one space.
    :ivar why: the reason for the difference.
    :ivar sometimes: whether the difference depends on chance, so that it may be absent.
    """

    file: str
    why: str
    kind: str = '*'
    name: str = '*'
    simulated: str = '*'
    real: str = '*'
    sometimes: bool = False

    def is_about(self, words: Sequence[str]) -> bool:
        """Return whether the row applies to this comparison."""
        return fnmatchcase(' '.join(words), self.file)

    def covers(self, words: Sequence[str], difference: Difference) -> bool:
        """Return whether the row explains this difference."""
        patterns = self.kind, self.name, self.simulated, self.real
        return self.is_about(words) and all(map(fnmatchcase, difference[:4], patterns))


BY_DESIGN = [
    Known(
        '*',
        'the planar Waffle accepts Twist and TwistStamped; a real program can subscribe to only one type per topic',
        'subscription',
        '/cmd_vel of /turtlebot3_diff_drive',
        sometimes=True,
    ),
    Known('*', 'the client was gone', 'output', real='*failed to send response (timeout)*', sometimes=True),
    Known('*', 'the client was gone', 'output', real='*self.__service.service_send_response(*', sometimes=True),
]
"""The differences that any launch file may have, and that cannot be avoided."""


def reason(known: Sequence[Known], words: Sequence[str], difference: Difference) -> Known | None:
    """Return the first row that explains a difference, or None if no row does."""
    return next((one for one in known if one.covers(words, difference)), None)


def split(known: Sequence[Known], words: Sequence[str], found: Sequence[Difference]) -> tuple[list[Difference], list[Known]]:
    """Return the differences that no row explains, and the rows that explain the other differences."""
    rows = {each: reason(known, words, each) for each in found}
    return [each for each in found if rows[each] is None], list(dict.fromkeys(row for row in rows.values() if row))


def read_known(path: str) -> list[Known]:
    """Return the rows of a table file, which is a list of mappings with the names of :class:`Known`.

    :raises UnusableInput: when the file cannot be read, or a row is invalid.
    """
    import yaml

    try:
        with open(path, encoding='utf-8') as file:
            return [Known(**row) for row in yaml.safe_load(file) or ()]
    except (OSError, ValueError, TypeError, RecursionError, yaml.YAMLError) as error:
        help = f'write a list of mappings with {", ".join(Known._fields)}; file and why are required'
        raise UnusableInput(f'{path!r} is not a table of known differences: {error}', help=help) from None

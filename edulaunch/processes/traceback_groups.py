"""The frame that Python draws around the members of an exception group in a traceback."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator

MOST = 15
"""So many members are shown, as Python shows by default."""


def members_of(error: BaseException) -> tuple[BaseException, ...]:
    """The members of an exception group, which Python has from 3.11 on; none of any other error."""
    members = getattr(error, 'exceptions', ())
    is_group = isinstance(members, tuple) and hasattr(error, 'derive') and hasattr(error, 'split')
    return members if is_group else ()


def within(text: str, depth: int, corner: str = '|') -> str:
    """The text inside `depth` frames; its first line begins with the `corner` of a new one."""
    if not depth:
        return text
    indent = '  ' * depth
    first, _, rest = text.partition('\n')
    return f'{indent}{corner} {first}\n' + textwrap.indent(rest, f'{indent}| ', lambda line: True)


def framed(members: tuple[BaseException, ...], depth: int, tell: Callable[[BaseException, int], Iterator[str]]) -> Iterator[str]:
    """The members one below the other in a frame of their own.

    :param depth: how many frames are around the group, its own among them.
    :param tell: gives the text of one member, inside so many frames.
    """
    indent = '  ' * depth
    shown = members[:MOST]
    closed = False
    for number, member in enumerate(shown, start=1):
        yield f'{indent}{"+-" if number == 1 else "  "}+---------------- {number} ----------------\n'
        yield from tell(member, depth + 1)
        closed = bool(members_of(member))
    if len(members) > MOST:
        more = len(members) - MOST
        yield f'{indent}  +---------------- ... ----------------\n'
        yield within(f'and {more} more exception{"s" if more > 1 else ""}\n', depth + 1)
        closed = False
    if not closed:  # the frame of a group that comes last closes the outer one too
        yield f'{indent}  +------------------------------------\n'

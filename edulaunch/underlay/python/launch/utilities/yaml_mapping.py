"""A mapping of a YAML file."""

from __future__ import annotations


class Mapping(dict):  # type: ignore[type-arg]
    """A mapping of the file.

    :ivar line: where its first key stands, from 1.
    """

    __slots__ = ('line',)

    line: int

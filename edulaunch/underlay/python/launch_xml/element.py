"""One XML element as read from a file."""

from __future__ import annotations


class Element(list['Element']):
    """The child elements, in order, with the same attributes as `xml.etree.ElementTree.Element` and the line.

    The standard library's fast element has no room for a line number; this one is as small.
    """

    __slots__ = ('tag', 'attrib', 'line')

    def __init__(self, tag: str, attrib: dict[str, str], line: int) -> None:
        self.tag = tag
        self.attrib = attrib
        self.line = line

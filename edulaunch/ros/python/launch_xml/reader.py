"""Converts XML text to elements that store their lines.

Launch files can come from untrusted sources. So the reader opens no other file, and limits the nesting. It also refuses
declarations of entities, because they could make the text very large.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts

if TYPE_CHECKING:
    from xml.etree.ElementTree import ParseError


class Element(list['Element']):
    """An element with the same attributes as `xml.etree.ElementTree.Element`, a list of child elements, and its line.

    The fast element of the standard library cannot store a line number. This element needs no more memory than the fast
    element.
    """

    __slots__ = ('tag', 'attrib', 'line')

    def __init__(self, tag: str, attrib: dict[str, str], line: int) -> None:
        self.tag = tag
        self.attrib = attrib
        self.line = line


MAX_DEPTH = 100
"""The maximum depth of nested elements."""


def read(text: str) -> Element:
    """Return the root element of an XML text.

    :raises xml.etree.ElementTree.ParseError: with the message and position of the standard library's parser.
    :raises ValueError: when the text declares entities, or is nested more than :data:`MAX_DEPTH` levels deep.
    """
    return _Reading().root_of(text)


class _Reading:
    """One run of expat, with the stack of open elements. The outermost element is the document itself."""

    def __init__(self) -> None:
        from pyexpat import ParserCreate

        self.expat: Any = ParserCreate(None, '}')
        self.expat.buffer_text = True
        self.expat.StartElementHandler = self.start
        self.expat.EndElementHandler = self.end
        self.expat.EntityDeclHandler = self.refuse_entity
        self.expat.SkippedEntityHandler = self.refuse_unknown_entity
        self.document = Element('', {}, 0)
        self.open = [self.document]

    def root_of(self, text: str) -> Element:
        from pyexpat import ExpatError

        try:
            self.expat.Parse(text, True)
        except ExpatError as error:
            raise self.broken(str(error), error.lineno, error.offset) from None
        except ValueError as error:
            error.edulaunch_line = self.expat.CurrentLineNumber  # type: ignore[attr-defined]
            raise
        return self.document[0]

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        if '}' in tag or '}' in ''.join(attributes):
            tag = _qualified(tag)
            attributes = {_qualified(name): value for name, value in attributes.items()}
        element = Element(tag, attributes, self.expat.CurrentLineNumber)
        opened = self.open
        if len(opened) > MAX_DEPTH:
            raise ValueError(f'elements are nested more than {MAX_DEPTH} levels deep')
        opened[-1].append(element)
        opened.append(element)

    def end(self, tag: str) -> None:
        self.open.pop()

    def refuse_entity(self, name: str, *_: Any) -> None:
        raise ValueError(f"the entity '{name}' is declared; launch files must not declare entities")

    def refuse_unknown_entity(self, name: str, is_parameter_entity: bool) -> None:
        line, column = self.expat.CurrentLineNumber, self.expat.CurrentColumnNumber
        raise self.broken(f'undefined entity &{name};: line {line}, column {column}', line, column)

    def broken(self, message: str, line: int, column: int) -> ParseError:
        """Return the standard library's error, with the elements that were still open as a hint."""
        from xml.etree.ElementTree import ParseError

        error: Any = ParseError(message)
        error.position = line, column
        error.edulaunch_line = line
        if len(self.open) > 1 and ('mismatched' in message or 'no element' in message):
            with_facts(error, 'launch.not-closed', tag=self.open[-1].tag, opened=self.open[-1].line)
        elif 'no element' in message:
            with_facts(error, 'launch.empty-file', at_margin=[])
        return error  # type: ignore[no-any-return]


def _qualified(name: str) -> str:
    """Return `{namespace}name`, the form of the standard library. expat omits the first brace."""
    return f'{{{name}' if '}' in name else name

"""Convert marks to diagnostics and edits of the Language Server Protocol.

All results are plain data. Columns are in UTF-16 units.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlparse

from edulaunch.advice.reader import Reader
from edulaunch.advice.rendering import rendered
from edulaunch.advice.rule import rule_named
from edulaunch.advice.texts.check import Marked
from edulaunch.advice.texts.edits import Edits
from edulaunch.advice.texts.text import Span, Text

SEVERITIES = {'error': 1, 'warning': 2, 'info': 3}
SOURCE = 'edulaunch'


def position(text: Text, offset: int) -> dict[str, int]:
    """Return an offset as a position of the protocol. Lines and characters count from 0, and characters are UTF-16 units."""
    line, column = text.place(offset)
    start = offset - column
    return {'line': line - 1, 'character': len(text.text[start:offset].encode('utf-16-le')) // 2}


def offset_of(text: Text, line: int, character: int) -> int:
    """Return the offset of a position of the protocol."""
    start, end = text.whole_line(line + 1)
    units = text.text[start:end].encode('utf-16-le')[: 2 * character]
    return start + len(units.decode('utf-16-le', errors='ignore'))


def range_of(text: Text, span: Span) -> dict[str, Any]:
    """Return a span as a range of the protocol."""
    return {'start': position(text, span.start), 'end': position(text, span.end)}


def changes(text: Text, edits: Edits) -> list[dict[str, Any]]:
    """Return the edits as `TextEdit` objects for one document."""
    return [{'range': range_of(text, edit.span), 'newText': edit.new} for edit in edits]


def title(edits: Edits) -> str:
    """Return the title of a quick fix for a menu."""
    edit = edits[-1]
    return f"replace '{edit.old}' by '{edit.new}'" if edit.old else f'add: {edit.new.strip()}'


def diagnostic(mark: Marked, text: Text, reader: Reader) -> dict[str, Any]:
    """Return a mark as a `Diagnostic`. Its `data` contain the edits and the title of the quick fix."""
    words = rendered(mark.finding, reader)
    data = {'title': title(mark.edits), 'changes': changes(text, mark.edits)} if mark.edits else None
    return {
        'range': range_of(text, mark.span),
        'severity': SEVERITIES[rule_named(mark.finding.rule).level],
        'code': mark.finding.rule,
        'source': SOURCE,
        'message': '\n'.join(filter(None, (words.what, words.why, words.do))),
        **({'data': data} if data else {}),
    }


def uri_of(path: str) -> str:
    """Return the URI of a file."""
    return Path(path).absolute().as_uri()


def path_of(uri: str) -> str:
    """Return the path in the URI of a document. The document may not be stored as a file."""
    return unquote(urlparse(uri).path)


def diagnostics(marks: Iterable[Marked], text: Text, reader: Reader) -> list[dict[str, Any]]:
    """Return the diagnostics for the marks of one file."""
    return [diagnostic(mark, text, reader) for mark in marks]

"""Writes HTML. Every string is escaped when it is added to an element, so that no content can change the page."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

VOID = ('img', 'meta', 'br')
POLICY = "default-src 'none'; style-src 'unsafe-inline'"
"""What a page may load: nothing."""


class Markup(str):
    """A string that is already HTML."""

    __slots__ = ()


def element(tag: str, /, *children: str, **attributes: str) -> Markup:
    """Return an element as HTML. Children that are not Markup are plain strings, and are escaped.

    :param attributes: attributes of the element. A name that is a keyword of Python ends in an underscore (``class_``). An
        underscore inside a name represents a hyphen (``http_equiv``).
    """
    words = ''.join(f' {key.rstrip("_").replace("_", "-")}="{escape(visible(value))}"' for key, value in attributes.items())
    if tag in VOID:
        return Markup(f'<{tag}{words}>')
    return Markup(f'<{tag}{words}>{joined(*children)}</{tag}>')


def joined(*children: str) -> Markup:
    """Return several pieces of HTML as one piece."""
    return Markup(''.join(child if isinstance(child, Markup) else escape(visible(child)) for child in children))


def table_row(*cells: str, kind: str = 'td') -> Markup:
    """Return a row of a table.

    :param kind: 'th' for a row of the header, 'td' for any other row.
    """
    return element('tr', *(element(kind, cell) for cell in cells))


def html_page(title: str, style: str, *body: str, policy: str = POLICY, meta: Sequence[Markup] = ()) -> str:
    """Return a whole HTML page.

    :param policy: the content security policy, which states what the browser may load for the page.
    :param meta: additional elements for the head of the page.
    """
    head = element(
        'head',
        element('meta', charset='utf-8'),
        element('meta', http_equiv='Content-Security-Policy', content=policy),
        *meta,
        element('title', title),
        element('style', Markup(style)),
    )
    return f'<!doctype html>\n{element("html", head, element("body", *body), lang="en")}\n'


def visible(text: str) -> str:
    """Replace control characters and lone surrogates, which HTML does not allow."""
    return ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text)

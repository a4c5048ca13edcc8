"""HTML that cannot be spoilt by what is written in it: every text is escaped when it becomes part of an element."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

VOID = ('img', 'meta', 'br')
POLICY = "default-src 'none'; style-src 'unsafe-inline'"
"""What a page may load: nothing."""


class Markup(str):
    """Text that is HTML already."""

    __slots__ = ()


def element(tag: str, /, *children: str, **attributes: str) -> Markup:
    """An element. Children that are no Markup are plain text.

    :param attributes: with an underscore at the end where the name is a word of Python (``class_``), and inside it for a
        hyphen (``http_equiv``).
    """
    words = ''.join(f' {key.rstrip("_").replace("_", "-")}="{escape(visible(value))}"' for key, value in attributes.items())
    if tag in VOID:
        return Markup(f'<{tag}{words}>')
    return Markup(f'<{tag}{words}>{joined(*children)}</{tag}>')


def joined(*children: str) -> Markup:
    """Several pieces one after the other."""
    return Markup(''.join(child if isinstance(child, Markup) else escape(visible(child)) for child in children))


def table_row(*cells: str, kind: str = 'td') -> Markup:
    """A line of a table.

    :param kind: 'th' for its head.
    """
    return element('tr', *(element(kind, cell) for cell in cells))


def html_page(title: str, style: str, *body: str, policy: str = POLICY, meta: Sequence[Markup] = ()) -> str:
    """A whole page.

    :param policy: what the browser may load for it.
    :param meta: more elements for its head.
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
    """Without control characters and half characters, which HTML has no place for."""
    return ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text)

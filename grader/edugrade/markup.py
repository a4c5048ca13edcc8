"""HTML that cannot be spoilt by what is written in it: every text is escaped when it becomes part of an element."""

from __future__ import annotations

from html import escape

VOID = ('img', 'meta', 'br')


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


def visible(text: str) -> str:
    """Without control characters and half characters, which HTML has no place for."""
    return ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text)

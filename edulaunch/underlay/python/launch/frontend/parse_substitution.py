"""From the text of an attribute to substitutions."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any

from edulaunch.facts import with_facts
from edulaunch.nearest import nearest

from ..substitution import Substitution
from ..substitutions.text_substitution import TextSubstitution
from .expose import substitution_parse_methods
from .extensions import load_launch_extensions
from .registry import ParseMethod
from .substitution_errors import VisitError
from .substitution_grammar import Call, Template, parse_template
from .substitution_parsers import LateSubstitution

_ESCAPE = re.compile(r'\\(.)', re.DOTALL)


def parse_substitution(string: str) -> list[Substitution]:
    """The substitutions that a text like `a$(var b)c` stands for, literal pieces as TextSubstitution.

    Built-in substitutions never change, so equal texts share them; those of extensions are made anew.

    :raises SubstitutionSyntaxError: see its subclasses; facts of the error say what was expected.
    """
    if '$(' not in string and '\\' not in string:
        return [_literal(string)]
    template = parse_template(string)
    return list(_shared(template) if _is_built_in(template) else _built(template))


def parse_if_substitutions(value: Any) -> Any:
    """As :func:`parse_substitution` for a text that contains `$(...)`; a plain text stays a (unescaped) text.

    Other scalars are returned as they are; a list is treated item by item.

    :raises ValueError: when the items of a list, but for those with substitutions, are not all of one type.
    """
    if isinstance(value, str):
        if '$(' not in value and '\\' not in value:
            return value
        parsed = parse_substitution(value)
        if len(parsed) == 1 and isinstance(parsed[0], TextSubstitution):
            return parsed[0].text
        return parsed
    if isinstance(value, list):
        items = [parse_if_substitutions(item) for item in value]
        if len({type(item) for item in items if not isinstance(item, list)}) > 1:
            raise ValueError(f'the items of a list must be of one type, got {value}')
        return items
    return value


def replace_escaped_characters(data: str) -> str:
    """Take each backslash away and keep the character after it."""
    return _ESCAPE.sub(r'\1', data) if '\\' in data else data


@lru_cache(maxsize=4096)
def _literal(text: str) -> TextSubstitution:
    return TextSubstitution(text=text)


def _built(template: Template) -> tuple[Substitution, ...]:
    # A text of nothing is still a value: the empty one.
    return tuple([_piece(piece) for piece in template]) or (_literal(''),)


_shared = lru_cache(maxsize=4096)(_built)


@lru_cache(maxsize=4096)
def _is_built_in(template: Template) -> bool:
    """Whether all calls are of built-in substitutions, whose names nothing else can take."""
    return all(
        isinstance(substitution_parse_methods.get(piece.name), LateSubstitution) and all(map(_is_built_in, piece.arguments))
        for piece in template
        if isinstance(piece, Call)
    )


def _piece(piece: str | Call) -> Substitution:
    if isinstance(piece, str):
        return _literal(piece)
    name, arguments = piece
    made = [[_piece(part) for part in argument] for argument in arguments]
    try:
        made_by, kwargs = (substitution_parse_methods.get(name) or _parse_method_of_extension(name))(made)
        substitution: Substitution = made_by(**kwargs)
    except Exception as error:
        # Like lark, of which upstream's users see the outer error only.
        near = nearest(name, substitution_parse_methods)
        known = name in substitution_parse_methods
        raise with_facts(VisitError('substitution', error), 'launch.call', call=name, near=near, is_known=known) from error
    return substitution


def _parse_method_of_extension(name: str) -> ParseMethod:
    _load_extensions_once()
    parse = substitution_parse_methods.get(name)
    if parse is None:
        raise RuntimeError(f'Unknown substitution: {name}')
    return parse


@lru_cache(maxsize=1)
def _load_extensions_once() -> None:
    load_launch_extensions()

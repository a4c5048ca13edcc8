"""The tables of elements and substitutions, with the functions that parse them."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from types import FunctionType, MethodType
from typing import Any, TypeVar

from .elements import ELEMENTS
from .substitution_parsers import BUILT_IN_SUBSTITUTIONS

ParseMethod = Callable[..., tuple[type, dict[str, Any]]]
"""Returns a class (or function), and its keyword arguments."""

action_parse_methods: dict[str, ParseMethod] = {}
"""Element name -> function (entity, parser) -> (class, keyword arguments)."""
substitution_parse_methods: dict[str, ParseMethod] = {}
"""Name of `$(name ...)` -> function (list of arguments) -> (class, keyword arguments)."""

__all__ = ['action_parse_methods', 'expose_action', 'expose_substitution', 'substitution_parse_methods']

Exposed = TypeVar('Exposed')

SIBLINGS = ('launch_ros',)
"""Packages that always extend launch, by their module `launch_extension`. Entry points find all others on request."""

action_parse_methods.update(ELEMENTS)
substitution_parse_methods.update(BUILT_IN_SUBSTITUTIONS)
for sibling in SIBLINGS:
    import_module(f'{sibling}.launch_extension')


def __expose_impl(name: str, parse_methods_map: dict[str, ParseMethod], exposed_type: str) -> Callable[[Exposed], Exposed]:
    """Return the decorator for :func:`expose_action` and :func:`expose_substitution`.

    The decorator takes a class with a `parse` method, or the parse function itself, and returns it unchanged.

    :raises RuntimeError: for anything else, and when other code has already used the name.
    """

    def expose(exposed: Exposed) -> Exposed:
        parse = _parse_method_of(exposed, name, exposed_type)
        if name in parse_methods_map and not _same_code(parse_methods_map[name], parse):
            raise RuntimeError(f'Two {exposed_type} parsing methods exposed with the same name: [{name}]')
        parse_methods_map[name] = parse
        return exposed

    return expose


def expose_substitution(name: str) -> Callable[[Exposed], Exposed]:
    """Return a decorator for a substitution that `$(name ...)` creates. Its `parse` receives the list of arguments."""
    return __expose_impl(name, substitution_parse_methods, 'substitution')


def expose_action(name: str) -> Callable[[Exposed], Exposed]:
    """Return a decorator for an action that the element `name` creates. Its `parse` receives the entity and the parser."""
    return __expose_impl(name, action_parse_methods, 'action')


def _parse_method_of(exposed: Any, name: str, exposed_type: str) -> ParseMethod:
    if isinstance(exposed, type):
        parse = getattr(exposed, 'parse', None)
        if not isinstance(parse, (FunctionType, MethodType)):
            raise RuntimeError("Did not find a method called 'parse' in the class being decorated.")
        return parse
    if callable(exposed):
        return exposed  # type: ignore[no-any-return]
    raise RuntimeError(f'Exposed {exposed_type} parser for {name} is not a callable or a class containing a parse method')


def _same_code(known: ParseMethod, new: ParseMethod) -> bool:
    """Return whether two parse functions have the same definition.

    A launch file that exposes its own element may be executed many times in one interpreter. In upstream, each run has a new
    interpreter. All versions of a notebook's cell count as one definition.
    """
    return _place(known) == _place(new)


def _place(parse: Any) -> tuple[object, ...]:
    code = getattr(parse, '__code__', None)
    names = (getattr(parse, '__module__', None), getattr(parse, '__qualname__', None))
    if code is None or names[0] == '__main__':
        return names
    return (*names, code.co_filename, code.co_firstlineno)

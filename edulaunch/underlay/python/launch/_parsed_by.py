"""The class method `parse` of actions and substitutions that XML and YAML files know.

Upstream each class defines its own; here all of them are in `launch.frontend`, which Python launch files
never load.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

Parse = Callable[..., tuple[type, dict[str, Any]]]


class _ParsedBy:
    """Descriptor for `parse`: calls the frontend's function for that element and answers with the class it
    was asked of.

    So `super().parse(entity, parser)` in a student's sub-class gives the keyword arguments of the base class.
    """

    def __init__(self, kind: str, name: str) -> None:
        self._kind = kind
        self._name = name

    def __get__(self, instance: object, owner: type | None = None) -> Parse:
        made = owner if owner is not None else type(instance)

        def parse(*args: Any) -> tuple[type, dict[str, Any]]:
            from .frontend import expose

            methods: dict[str, Any] = getattr(expose, f'{self._kind}_parse_methods')
            return made, methods[self._name](*args)[1]

        return parse


def parsed_as_action(element: str) -> Any:
    """`parse(entity, parser)` of an action that is the XML or YAML element of that name."""
    return _ParsedBy('action', element)


def parsed_as_substitution(name: str) -> Any:
    """`parse(data)` of a substitution that is written `$(name ...)`."""
    return _ParsedBy('substitution', name)

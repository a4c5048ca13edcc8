"""The part of a parser that parsers of single elements need. It prevents circular imports."""

from __future__ import annotations

from typing import Any, Protocol

from ..substitution import Substitution
from .entity import Entity


class ParserProtocol(Protocol):
    """A parser of launch files; see :class:`~launch.frontend.Parser`."""

    def parse_action(self, entity: Entity) -> Any:
        """Return the action of an element."""

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Return the substitutions in a string that may contain `$(...)`."""

    def parse_if_substitutions(self, value: Any) -> Any:
        """Parse a value that may contain `$(...)`. The value may be a string, another scalar or a list."""

    def escape_characters(self, value: str) -> str:
        """Return a string without its backslashes."""

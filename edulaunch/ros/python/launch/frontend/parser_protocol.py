"""The part of a parser that readers of single elements need, so that these files do not import each other."""

from __future__ import annotations

from typing import Any, Protocol

from ..substitution import Substitution
from .entity import Entity


class ParserProtocol(Protocol):
    """See :class:`~launch.frontend.Parser`."""

    def parse_action(self, entity: Entity) -> Any:
        """Return the action of an element."""

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Return a string with its `$(...)` as substitutions."""

    def parse_if_substitutions(self, value: Any) -> Any:
        """Do the same for a value that need not be a string, and for lists."""

    def escape_characters(self, value: str) -> str:
        """Return a string without its backslashes."""

"""The part of a parser that readers of single elements need. It avoids imports in a circle."""

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
        """Parse a value that may contain `$(...)`. It need not be a string, and may be a list."""

    def escape_characters(self, value: str) -> str:
        """Return a string without its backslashes."""

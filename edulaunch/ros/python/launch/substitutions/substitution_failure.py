"""The error for a substitution that has no text."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    pass


class SubstitutionFailure(RuntimeError):
    """A substitution could not be evaluated."""

"""The error for a substitution that cannot be evaluated."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    pass


class SubstitutionFailure(RuntimeError):
    """A substitution could not be evaluated."""

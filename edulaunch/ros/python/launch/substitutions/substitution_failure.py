"""The error for a substitution that cannot be evaluated."""

from __future__ import annotations


class SubstitutionFailure(RuntimeError):
    """A substitution could not be evaluated."""

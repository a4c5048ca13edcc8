"""Substitutions in words."""

from __future__ import annotations

from collections.abc import Iterable

from ..substitution import Substitution


def describe_all(substitutions: Iterable[Substitution]) -> str:
    """Several substitutions that are joined: `'a' + LaunchConfig('b')`."""
    return ' + '.join([substitution.describe() for substitution in substitutions])

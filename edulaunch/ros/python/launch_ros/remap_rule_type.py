"""Types of remapping rules."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from launch.substitution import SomeSubstitutionsType, Substitution

SomeRemapRule = tuple[SomeSubstitutionsType, SomeSubstitutionsType]
"""A pair (from, to) as a launch file writes it."""


SomeRemapRules = Iterable[SomeRemapRule]


RemapRule = tuple[tuple[Substitution, ...], tuple[Substitution, ...]]
"""The same pair, normalized."""


RemapRules = Sequence[RemapRule]

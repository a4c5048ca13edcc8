"""Types of remap rules."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Tuple

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution

SomeRemapRule = Tuple[SomeSubstitutionsType, SomeSubstitutionsType]
"""A pair (from, to) as a launch file writes it."""
SomeRemapRules = Iterable[SomeRemapRule]
RemapRule = Tuple[Tuple[Substitution, ...], Tuple[Substitution, ...]]
"""The same pair, normalized."""
RemapRules = Sequence[RemapRule]

"""What may be given wherever a text may contain substitutions."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable

from .substitution import Substitution

SomeSubstitutionsType = str | Substitution | Iterable[str | Substitution]
"""A text, a substitution, or several of them, which are joined without a separator."""

SomeSubstitutionsType_types_tuple = (str, Substitution, collections.abc.Iterable)

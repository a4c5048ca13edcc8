"""What may be given wherever a text may contain substitutions."""
from __future__ import annotations

import collections.abc
from collections.abc import Iterable
from typing import Union

from .substitution import Substitution

SomeSubstitutionsType = Union[str, Substitution, Iterable[str | Substitution]]
"""A text, a substitution, or several of them, which are joined without a separator."""

SomeSubstitutionsType_types_tuple = (str, Substitution, collections.abc.Iterable)

"""Texts as booleans, for the boolean substitutions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..substitution import Substitution
from ..utilities.perform_substitutions_impl import perform_substitutions
from ..utilities.type_utils import coerce_to_type
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def truth(context: LaunchContext, substitutions: Iterable[Substitution]) -> bool:
    """YAML's booleans (true, yes, on ...) and 1 and 0.

    :raises SubstitutionFailure: for any other text.
    """
    try:
        return bool(coerce_to_type(perform_substitutions(context, substitutions), bool))
    except ValueError as error:
        raise SubstitutionFailure(str(error)) from error

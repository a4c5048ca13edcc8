"""Texts and substitutions as a list of substitutions."""

from __future__ import annotations

from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..substitutions.text_substitution import TextSubstitution


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """A text, a substitution or an iterable of both as a list; plain texts become :class:`TextSubstitution`.

    :raises TypeError: for any other item, naming its type.
    """
    if isinstance(subs, str):
        return [TextSubstitution(text=subs)]
    if isinstance(subs, Substitution):
        return [subs]
    return [item if isinstance(item, Substitution) else _normalize(item) for item in subs]


def _normalize(item: object) -> Substitution:
    if isinstance(item, str):
        return TextSubstitution(text=item)
    raise TypeError(
        f"Failed to normalize given item of type '{type(item)}', when only 'str' or 'launch.Substitution' were expected."
    )

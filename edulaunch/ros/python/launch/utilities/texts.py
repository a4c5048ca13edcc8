"""Converts strings and substitutions to one list, and such a list to one string."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..substitution import SomeSubstitutionsType, Substitution
from ..substitutions.text_substitution import TextSubstitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def plain_text(value: Any) -> str | None:
    """Return the string itself, or the only item of a list or tuple that contains exactly one literal string. Otherwise, return
    None.

    Nearly all values in launch files have this form, and the general evaluation takes ten times as long.
    """
    kind = type(value)
    if kind is str:
        return value  # type: ignore[no-any-return]
    if (kind is list or kind is tuple) and len(value) == 1 and type(value[0]) is TextSubstitution:
        return value[0].text
    return None


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """Return a string, a substitution, or an iterable of strings and substitutions, as a list. Plain strings become
    :class:`TextSubstitution`.

    :raises TypeError: for any other item. The message contains the type of the item.
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


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Evaluate each substitution, and join the strings without a separator."""
    text = plain_text(subs)
    return ''.join([context.perform_substitution(sub) for sub in subs]) if text is None else text

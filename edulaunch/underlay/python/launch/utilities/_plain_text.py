"""Texts that are known without evaluating anything."""

from __future__ import annotations

from typing import Any

from ..substitutions.text_substitution import TextSubstitution


def plain_text(value: Any) -> str | None:
    """The text of a `str`, or of a list or tuple with nothing but one literal text in it; None for the rest.

    Launch files hold hardly anything else, and to evaluate them the general way is ten times the work.
    """
    kind = type(value)
    if kind is str:
        return value  # type: ignore[no-any-return]
    if (kind is list or kind is tuple) and len(value) == 1 and type(value[0]) is TextSubstitution:
        return value[0].text
    return None

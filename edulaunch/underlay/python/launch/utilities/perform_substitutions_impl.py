"""Several substitutions as one text."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..substitution import Substitution
from ._plain_text import plain_text

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Evaluate each and join the texts without a separator."""
    text = plain_text(subs)
    return ''.join([context.perform_substitution(sub) for sub in subs]) if text is None else text

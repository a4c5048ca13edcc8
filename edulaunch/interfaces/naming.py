"""Names of types, and the nearest of several names."""

from __future__ import annotations

import re
from collections.abc import Iterable


def module_name(type_name: str) -> str:
    """The module that ROS generates for a type name: 'TransformStamped' -> 'transform_stamped', 'Pose2D' ->
    'pose2_d'.
    """
    spaced = re.sub('(.)([A-Z][a-z]+)', r'\1_\2', type_name)
    return re.sub('([a-z0-9])([A-Z])', r'\1_\2', spaced).lower()


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like `name`, or None when none is alike. Case and a leading pkg/ count little."""
    from difflib import get_close_matches  # 2 ms, needed only once something is wrong

    names = sorted(known)
    by_lower = {candidate.lower(): candidate for candidate in reversed(names)}
    matches = get_close_matches(name.lower(), by_lower, n=1, cutoff=0.6)
    return by_lower[matches[0]] if matches else None


def did_you_mean(name: str, known: Iterable[str]) -> str | None:
    """A line of help with the nearest known name, or None."""
    match = nearest(name, known)
    return None if match is None else f"did you mean '{match}'?"

"""The nearest match among known names, for "did you mean" lines."""

from __future__ import annotations

from collections.abc import Iterable


def nearest(name: str, names: Iterable[str]) -> str | None:
    """The known name that `name` was probably meant to be, or None when nothing is close.

    Case and the three usual separators are looked through first (`My-Robot` finds `my_robot`); ties go to the
    alphabet.
    """
    known = sorted(set(names))
    folded = {_folded(candidate): candidate for candidate in reversed(known)}
    same = folded.get(_folded(name))
    if same is not None:
        return same
    from difflib import get_close_matches

    close = get_close_matches(_folded(name), list(folded), n=1, cutoff=0.6)
    return folded[close[0]] if close else None


def _folded(name: str) -> str:
    return name.lower().replace('-', '_').replace('.', '_')


def did_you_mean(name: str, names: Iterable[str]) -> str | None:
    """The line of help that names the nearest of the known names; None when nothing is close."""
    near = nearest(name, names)
    return None if near is None else f'did you mean {near!r}?'

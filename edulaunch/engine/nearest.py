"""The nearest match among known names, for "did you mean" lines.

The module is in no package of the engine, because all parts of edulaunch use it.
"""

from __future__ import annotations

from collections.abc import Iterable


def nearest(name: str, names: Iterable[str]) -> str | None:
    """Return the known name that is most similar to `name`, or None if no name is similar.

    The search ignores case, and treats `-`, `.` and `_` as equal (`My-Robot` finds `my_robot`). If several names differ only
    in these characters, the first name in alphabetical order is returned.
    """
    return next(iter(nearest_few(name, names, 1)), None)


def nearest_few(name: str, names: Iterable[str], most: int) -> list[str]:
    """Return at most `most` known names that are similar to `name`, the most similar one first.

    If a known name differs only in case and separators, return only this name.
    """
    folded = {_folded(candidate): candidate for candidate in sorted(set(names), reverse=True)}
    if same := folded.get(_folded(name)):
        return [same]
    from difflib import get_close_matches

    return [folded[close] for close in get_close_matches(_folded(name), list(folded), n=most, cutoff=0.6)]


def nearest_name(name: str, names: Iterable[str]) -> str | None:
    """Return the known full name that is most similar to `name`, or None. The last parts of both names must be equal or nearly
    equal.

    `/turtle1/cmd_vel` may mean `/red/turtle1/cmd_vel`, but not `/turtle1/pose`, although many letters are equal.
    """
    last = name.rpartition('/')[2]
    return nearest(name, [known for known in names if nearest(last, [known.rpartition('/')[2]]) is not None])


def nearest_spelling(name: str, names: Iterable[str]) -> str | None:
    """Return the known name of which `name` is a misspelling, or None if no known name is close enough.

    The names may differ by two letters, or by a fifth of the letters of a longer name. Use this function for packages,
    modules and programs, where `vision_msgs` and `visualization_msgs` are different things.
    """
    folded = _folded(name.removesuffix('.py'))  # a program may be named with the ending of its file, or without
    close = [one for one in nearest_few(name, names, 3) if not _has_other_word(name, one)]
    return next((one for one in close if _edits(folded, _folded(one.removesuffix('.py'))) <= max(2, len(name) // 5)), None)


def _has_other_word(name: str, near: str) -> bool:
    """Return whether two names of several words contain clearly different words, such as `color_qos` and `color_fps`."""
    pairs = zip(name.split('_'), near.split('_'), strict=True) if name.count('_') == near.count('_') > 0 else ()
    return any(_is_other(one, two) for one, two in pairs if one != two)


def _is_other(one: str, other: str) -> bool:
    """Return whether two words differ clearly, or one is the other one with letters before it, such as `xarm` and `arm`."""
    is_far = _edits(one, other) > max(1, len(one) // 2) and sorted(one) != sorted(other)
    return is_far or one.endswith(other) or other.endswith(one)


def _edits(one: str, other: str) -> int:
    """Return the number of letters to insert, remove or replace that turn one string into the other one."""
    row = list(range(len(other) + 1))
    for count, letter in enumerate(one, 1):
        before, row[0] = row[0], count
        for place, wanted in enumerate(other, 1):
            before, row[place] = row[place], min(row[place] + 1, row[place - 1] + 1, before + (letter != wanted))
    return row[-1]


def nearest_file(name: str, names: Iterable[str]) -> str | None:
    """Return the known file name that is most similar to `name`, or None if no name is similar.

    First, only the parts before the endings are compared, because `.launch.py` alone does not make two names similar.
    """
    files = sorted(one for one in names if _stem(one) and _edits(_stem(name), _stem(one)) <= max(2, len(_stem(one)) // 2))
    stem = nearest(_stem(name), map(_stem, files))
    alike = [file for file in files if _stem(file) == stem]
    return nearest(name, alike) or next(iter(alike), None)


def _stem(file: str) -> str:
    return _folded(file.partition('.')[0]).removesuffix('_launch')


def _folded(name: str) -> str:
    return name.lower().replace('-', '_').replace('.', '_')


def did_you_mean(name: str, names: Iterable[str]) -> str | None:
    """Return a line of help that suggests the nearest known name, or None if no name is similar."""
    return f'did you mean {near!r}?' if (near := nearest(name, names)) else None

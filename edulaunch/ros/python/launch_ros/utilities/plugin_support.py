"""Checks whether an installed extension supports the version of an extension point."""

from __future__ import annotations

PLUGIN_SYSTEM_VERSION = '0.1'


class PluginException(Exception):
    """An extension does not support the version of its extension point."""


def satisfies_version(version: str, caret_range: str) -> None:
    """Check that `version`, the version of the extension point, is in the range.

    For example, '^0.1' means 0.1 or a later version with the same leftmost non-zero number.

    :raises PluginException: when the version is older or newer than the range.
    :raises ValueError: for a range that does not begin with a caret.
    """
    if not caret_range.startswith('^'):
        raise ValueError(f"'{caret_range}' is no caret range, such as '^0.1'")
    found, wanted = _numbers(version), _numbers(caret_range[1:])
    if found < wanted:
        raise PluginException(f"Extension point is too old ('{version}'), the extension requires '{caret_range}'")
    if found >= _first_incompatible(wanted):
        raise PluginException(f"Extension point is newer ('{version}'), than what the extension supports '{caret_range}'")


def _numbers(version: str) -> list[int]:
    return [int(number) for number in version.split('.')]


def _first_incompatible(wanted: list[int]) -> list[int]:
    leftmost = next((place for place, number in enumerate(wanted) if number), len(wanted) - 1)
    return [*wanted[:leftmost], wanted[leftmost] + 1]

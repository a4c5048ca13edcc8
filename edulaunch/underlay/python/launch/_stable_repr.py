"""Texts of objects that are the same in every run."""

from __future__ import annotations


class StableRepr:
    """Python's default `repr` without the address.

    Some of launch's error messages contain the `repr` of substitutions and actions. An address would make two
    equal runs print different texts, so only its `0x` is left of it.
    """

    def __repr__(self) -> str:
        cls = type(self)
        return f'<{cls.__module__}.{cls.__qualname__} object at 0x>'

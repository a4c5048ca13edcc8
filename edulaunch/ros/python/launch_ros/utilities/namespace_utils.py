"""Namespaces: whether they are absolute, and one put before another."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    pass


def is_root_namespace(ns: str) -> bool:
    """Return whether it is `/`."""
    return ns == '/'


def is_namespace_absolute(ns: str) -> bool:
    """Return whether it begins with `/`."""
    return ns.startswith('/')


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """`ns` inside `base_ns`; an absolute `ns` stays. None means "not given", and None in both stays None."""
    if base_ns is None and ns is None:
        return None
    if ns is None:
        joined = base_ns or ''
    elif not base_ns or is_namespace_absolute(ns):
        joined = ns
    elif not ns:
        joined = base_ns
    else:
        joined = (base_ns if is_root_namespace(base_ns) else base_ns + '/') + ns
    return joined.rstrip('/') if joined.endswith('/') and not is_root_namespace(joined) else joined


def make_namespace_absolute(ns: str | None) -> str | None:
    """`ns` with a leading `/`; None stays None."""
    if ns is None or is_namespace_absolute(ns):
        return ns
    return '/' + ns

"""Functions that check and join namespaces."""

from __future__ import annotations


def is_root_namespace(ns: str) -> bool:
    """Return whether a namespace is `/`."""
    return ns == '/'


def is_namespace_absolute(ns: str) -> bool:
    """Return whether a namespace begins with `/`."""
    return ns.startswith('/')


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """Return `ns` inside `base_ns`. An absolute `ns` does not change. None means that no namespace is given.

    Return None if neither namespace is given.
    """
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
    """Return `ns` with a leading `/`. Return None for None."""
    if ns is None or is_namespace_absolute(ns):
        return ns
    return '/' + ns

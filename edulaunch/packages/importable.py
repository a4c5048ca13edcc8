"""The interfaces that one sees over an index: those of the underlay, and what workspaces add."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry
    from edulaunch.packages.index import Index


def interfaces_of(index: Index) -> tuple[frozenset[str], Registry]:
    """The packages whose interfaces come from a workspace, and the registry of all.

    Packages that the underlay has too keep the underlay's interfaces, since its programs talk with them; they are taken from
    the workspace only when that has types which the underlay lacks.
    """
    from edulaunch.interfaces.registry import Registry, underlay_registry
    from edulaunch.underlay_place import underlay_prefix

    shared, inside = underlay_registry(), os.path.join(underlay_prefix(), 'share')
    folders = {os.path.basename(folder): folder for folder in index.interface_roots() if os.path.dirname(folder) != inside}
    own = frozenset(name for name in folders if not shared.has(name) or _adds(folders[name], name, shared))
    if not own:
        return own, shared
    roots = list(dict.fromkeys(os.path.dirname(folder) for folder in folders.values()))
    return own, Registry(roots, shared, leave=frozenset(folders) - own)


def _adds(folder: str, package: str, shared: Registry) -> bool:
    """Whether a share folder has an interface that the underlay's package of that name lacks."""
    return any(
        name.removesuffix(f'.{kind}') not in shared.names(package, kind)
        for kind in ('msg', 'srv', 'action')
        if os.path.isdir(os.path.join(folder, kind))
        for name in sorted(os.listdir(os.path.join(folder, kind)))
        if name.endswith(f'.{kind}')
    )

"""Which components there are: each package names its own in `share/<package>/components.txt`."""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.packages import Index


def components_of(index: Index, package: str) -> dict[str, str]:
    """Names of a package's components (`demo_nodes_cpp::Talker`), in order, with `module:name` of what makes each."""
    try:
        with open(os.path.join(index.share(package) or '', 'components.txt'), encoding='utf-8') as file:
            pairs = [line.partition(' = ') for line in file.read().splitlines()]
    except OSError:
        return {}
    return {name: target for name, _, target in pairs}


def packages_with_components(index: Index) -> list[str]:
    """Names of the packages that have some, sorted."""
    return [package for package in index.packages() if components_of(index, package)]


def factory_of(target: str) -> Callable[..., Any]:
    """What makes a node, called with the options of a Node."""
    module, _, name = target.partition(':')
    found: Callable[..., Any] = getattr(import_module(module), name)
    return found

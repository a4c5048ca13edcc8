"""Message, service and action classes made from .msg, .srv and .action text; wire tuples.

Reading order: `spec` (what an interface is), `notation` and `parser` (from text), `layout` (flattened fields), `generator` and
`services` (the classes), `registry` (finds files, makes each class once), `importer` (`import geometry_msgs.msg`), `texts`
(kept in recordings). The forms that leave the simulation, such as CDR, are in `edulaunch.ros.serialization`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.registry import Registry


def install(registry: Registry | None = None) -> None:
    """Make `import geometry_msgs.msg` and the like work, with the interfaces of a registry (default: those of
    the underlay).
    """
    from edulaunch.engine.interfaces.importer import install as install_finder
    from edulaunch.engine.interfaces.registry import underlay_registry

    install_finder(registry or underlay_registry())


def current_registry() -> Registry:
    """The registry whose interfaces can be imported at present: the running program's workspace over the
    underlay; outside any program the installed one, or the underlay's.
    """
    from edulaunch.engine.interfaces.importer import installed_registry
    from edulaunch.engine.interfaces.registry import running_registry, underlay_registry

    return running_registry() or installed_registry() or underlay_registry()

"""Message, service and action classes from .msg, .srv and .action files, and wire tuples.

Read the files in this order: `spec` (definition of an interface), `notation` and `parser` (reading interface files), and `layout`
(flat fields). Then read `generator` and `services` (the classes), `registry` (finds files, creates each class once), `importer`
(`import geometry_msgs.msg`), and `texts` (definitions that recordings store). `edulaunch.ros.serialization` has the forms that
leave the simulation, such as CDR.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.registry import Registry


def install(registry: Registry | None = None) -> None:
    """Make imports such as `import geometry_msgs.msg` work, with the interfaces of a registry (default: the underlay's
    registry).
    """
    from edulaunch.engine.interfaces.importer import install as install_finder
    from edulaunch.engine.interfaces.registry import underlay_registry

    install_finder(registry or underlay_registry())


def current_registry() -> Registry:
    """Return the registry of importable interfaces.

    For a running program, it contains the interfaces of the program's workspace and of the underlay. Outside programs, return the
    installed registry or, if none is installed, the underlay's registry.
    """
    from edulaunch.engine.interfaces.importer import installed_registry
    from edulaunch.engine.interfaces.registry import running_registry, underlay_registry

    return running_registry() or installed_registry() or underlay_registry()

"""The interfaces that the running program sees."""

from __future__ import annotations

from edulaunch.interfaces.registry import Registry, running_registry


def current_registry() -> Registry:
    """Those of the program's workspace over the underlay's; outside any program the underlay's."""
    from edulaunch.interfaces.registry import underlay_registry

    return running_registry() or underlay_registry()

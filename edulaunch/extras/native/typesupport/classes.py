"""Select the classes for the real rclpy. Types that its C++ code handles itself keep their own classes; all other types get
edulaunch's classes.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from edulaunch.engine.interfaces.importer import InterfaceFinder
from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.services import Action, Service
from edulaunch.extras.native.typesupport import interrupts
from edulaunch.extras.native.typesupport.messages import support_message
from edulaunch.extras.native.typesupport.services import support_action, support_service

ITS_OWN = frozenset(
    ('action_msgs', 'lifecycle_msgs', 'rcl_interfaces', 'rosgraph_msgs', 'service_msgs', 'type_description_interfaces')
)
"""The packages whose messages the C++ code of rclpy itself creates and reads."""


class SupportedClasses(Registry):
    """A registry whose classes the real rclpy can use directly."""

    def _make(self, spec: Any) -> type[Any]:
        cls = super()._make(spec)
        if issubclass(cls, Message):
            return support_message(cls, self)
        if issubclass(cls, Service):
            return support_service(cls, self)
        assert issubclass(cls, Action)
        return support_action(cls, self)


class _Finder(InterfaceFinder):
    """Makes these classes importable in place of compiled classes of the same name."""

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        return None if fullname.partition('.')[0] in ITS_OWN else super().find_spec(fullname, path, target)


Layers = Sequence[tuple[Sequence[str], Sequence[str]]]
"""Share folders, each with the packages in it that a lower layer also has. The lowest layer comes first."""


def layered(layers: Layers) -> SupportedClasses:
    """Return a registry that contains all the layers."""
    registry: SupportedClasses | None = None
    for roots, leave in layers:
        registry = SupportedClasses(roots, registry, leave)
    assert registry is not None
    return registry


def install(layers: Layers) -> None:
    """Make interfaces importable for the real rclpy.

    A message that contains one of :data:`ITS_OWN` contains edulaunch's class of that type, which is equal but not identical.
    """
    interrupts.defer()
    sys.meta_path.insert(0, _Finder(layered(layers)))

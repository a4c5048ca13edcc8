"""The fixtures of the interfaces: message classes, and arbitrary legal wire tuples."""

from __future__ import annotations

from tests.engine.interfaces.conftest import define, get, message_classes, registry, some_wires

__all__ = ['define', 'get', 'message_classes', 'registry', 'some_wires']

"""The rule for hidden names, which tools leave out of lists."""

from __future__ import annotations

from edulaunch.engine.graph.names import is_hidden


def topic_or_service_is_hidden(name: str) -> bool:
    """Return whether any part of the name begins with an underscore."""
    return is_hidden(name)

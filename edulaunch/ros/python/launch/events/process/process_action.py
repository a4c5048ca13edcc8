"""The part of an action that the events of its process need."""

from __future__ import annotations

from typing import Any, Protocol


class ProcessAction(Protocol):
    """The part of :class:`~launch.actions.ExecuteLocal` that events need. With this protocol, the modules of events and actions
    need not import each other.
    """

    @property
    def process_description(self) -> Any:
        """The `Executable` that the action runs."""

    @property
    def process_details(self) -> dict[str, Any] | None:
        """The name, command, folder, environment and process ID of the process; None before execution."""

    @property
    def return_code(self) -> int | None:
        """The exit code; None while the process runs."""

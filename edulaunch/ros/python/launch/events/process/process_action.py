"""The part of an action that the events of its program need."""

from __future__ import annotations

from typing import Any, Protocol


class ProcessAction(Protocol):
    """See :class:`~launch.actions.ExecuteLocal`; the events' files and that of the action do not import each other."""

    @property
    def process_description(self) -> Any:
        """The `Executable` that it runs."""

    @property
    def process_details(self) -> dict[str, Any] | None:
        """Name, command, folder, environment and number of the process; None before it has started."""

    @property
    def return_code(self) -> int | None:
        """The exit code, None while it runs."""

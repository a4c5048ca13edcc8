"""Records of each process of a launch test."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, TypeVar

from edulaunch.engine.sim.sync import Condition

from .util.proc_lookup import process_name

Recorded = TypeVar('Recorded')


class _ByProcess(Generic[Recorded]):
    """The records of each process, indexed by its action or by a part of its launch name."""

    def __init__(self) -> None:
        self._recorded: dict[Any, Recorded] = {}
        self._changed = Condition()

    def __contains__(self, key: object) -> bool:
        return any(key is action or (isinstance(key, str) and key in process_name(action)) for action in self._recorded)

    def __getitem__(self, key: Any) -> Recorded:
        """Return the records of an action, or of the first process with `key` in its name.

        :raises KeyError: for an unknown process.
        """
        if isinstance(key, str):
            key = next((action for action in self._recorded if key in process_name(action)), key)
        return self._recorded[key]

    def processes(self) -> list[Any]:
        """Return the actions of the processes."""
        return list(self._recorded)

    def process_names(self) -> list[str]:
        """Return the launch names of the processes, such as 'talker-1'."""
        return [process_name(action) for action in self._recorded]

    def _wait(self, has_come: Callable[[], bool], timeout: float) -> bool:
        with self._changed:
            return bool(self._changed.wait_for(has_come, timeout))

    def _tell(self) -> None:
        with self._changed:
            self._changed.notify_all()

"""The outline of a plan: what leads to what, and what is left out and why. For people; the plan format has a flat
list."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes import Origin

Item = dict[str, Any]


class Branch:
    """One action that launch came to, or an event, with everything that it leads to.

    :param action: the action; for an event what happens, in words.
    :ivar item: of the plan; None for an action that only holds others, or was not executed.
    :ivar condition: in words; None when there is none.
    :ivar is_taken: whether the action was executed.
    :ivar origin: where a launch file made the action.
    :ivar origins: of a node, parameter name -> where the launch file gives it.
    :ivar file_origins: of a node, parameter name -> where a parameter file gives it.
    :ivar missing_files: of a node, parameter files that are not there.
    """

    __slots__ = ('action', 'item', 'condition', 'is_taken', 'origin', 'origins', 'file_origins', 'missing_files', 'children')

    def __init__(self, action: Any, origin: Origin | None = None, condition: str | None = None) -> None:
        self.action = action
        self.origin = origin
        self.condition = condition
        self.item: Item | None = None
        self.is_taken = False
        self.origins: dict[str, str] = {}
        self.file_origins: dict[str, str] = {}
        self.missing_files: list[str] = []
        self.children: list[Branch] = []

    def add(self, branch: Branch) -> Branch:
        """Put a branch at the end."""
        self.children.append(branch)
        return branch

"""The outline of a plan: what leads to what, and what is left out and why. For people; the plan format has a flat
list."""

from __future__ import annotations

from collections.abc import Mapping
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
    :ivar parent_origin: the same of the branch that this one hangs on.
    :ivar setters: launch configuration -> the branch that has set or declared it last, before this action.
    """

    __slots__ = ('action', 'item', 'condition', 'is_taken', 'origin', 'parent_origin', 'setters', 'children')

    def __init__(self, action: Any, origin: Origin | None = None, condition: str | None = None) -> None:
        self.action = action
        self.origin = origin
        self.parent_origin: Origin | None = None
        self.condition = condition
        self.item: Item | None = None
        self.is_taken = False
        self.setters: Mapping[str, Branch] = {}
        self.children: list[Branch] = []

    def add(self, branch: Branch) -> Branch:
        """Put a branch at the end."""
        self.children.append(branch)
        branch.parent_origin = self.origin
        return branch


class Setters:
    """Which branch has set each launch configuration, as scopes open and close; of one that is declared, the declaration,
    whose own :attr:`Branch.setters` says who came before it."""

    def __init__(self) -> None:
        self._outer: list[Mapping[str, Branch]] = []
        self._now: Mapping[str, Branch] = {}

    def executed(self, branch: Branch) -> None:
        """Take note of an action that was just executed."""
        branch.setters = now = self._now
        kind = type(branch.action).__name__
        item = branch.item
        if kind == 'PushLaunchConfigurations':
            self._outer.append(now)
        elif kind == 'PopLaunchConfigurations' and self._outer:
            self._now = self._outer.pop()
        elif kind == 'ResetLaunchConfigurations' and item is not None:
            self._now = {name: setter for name, setter in now.items() if name in item['kept']}
        elif item is not None and item['kind'] == 'unset_configuration':
            self._now = {name: setter for name, setter in now.items() if name != item['name']}
        elif item is not None and item['kind'] in ('set_configuration', 'argument'):
            self._now = {**now, item['name']: branch}

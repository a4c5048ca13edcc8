"""What a check looks at: the recordings of a rubric's scenarios, and the submission's text."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar

from .scenario import Scenario
from .source import Source

if TYPE_CHECKING:
    from edulaunch.recording import Recording

Found = TypeVar('Found')


class Evidence(Mapping[str, 'Recording']):
    """The recording of each scenario by its name, in the rubric's order.

    :ivar source: the submission as text, for saying where a thing belongs. Marks never depend on it.
    :ivar names: what the cells of a notebook have defined, of the names that the rubric of a turn looks at.
    """

    def __init__(
        self,
        scenarios: Mapping[str, Scenario],
        recordings: Mapping[str, Recording],
        source: Source,
        names: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        self._scenarios = dict(scenarios)
        self._recordings = dict(recordings)
        self.source = source
        self.names = names
        self._found: dict[Hashable, Any] = {}

    def __getitem__(self, scenario: str) -> Recording:
        return self._recordings[scenario]

    def __iter__(self) -> Iterator[str]:
        return iter(self._recordings)

    def __len__(self) -> int:
        return len(self._recordings)

    def only(self, names: Sequence[str]) -> Evidence:
        """The same for some of the scenarios."""
        return Evidence(self._scenarios, {name: self[name] for name in self if name in names}, self.source, self.names)

    @property
    def first(self) -> Recording:
        """The recording of the first scenario: enough for facts that are the same in every run."""
        return next(iter(self._recordings.values()))

    def once(self, key: Hashable, find: Callable[[], Found]) -> Found:
        """What `find` gives, found once for all checks: for what takes long and is asked again and again."""
        if key not in self._found:
            self._found[key] = find()
        found: Found = self._found[key]
        return found

    def scenario(self, name: str) -> Scenario:
        """The scenario of that name: its arguments, duration and seed."""
        return self._scenarios[name]

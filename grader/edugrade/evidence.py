"""What a check looks at: the recordings of a rubric's scenarios, and the submission's text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from .scenario import Scenario
from .source import Source

if TYPE_CHECKING:
    from edulaunch.recording import Recording


class Evidence(Mapping[str, 'Recording']):
    """The recording of each scenario by its name, in the rubric's order.

    :ivar source: the submission as text, for saying where a thing belongs. Marks never depend on it.
    """

    def __init__(
        self, scenarios: Mapping[str, Scenario], recordings: Mapping[str, Recording], source: Source
    ) -> None:
        self._scenarios = dict(scenarios)
        self._recordings = dict(recordings)
        self.source = source

    def __getitem__(self, scenario: str) -> Recording:
        return self._recordings[scenario]

    def __iter__(self) -> Iterator[str]:
        return iter(self._recordings)

    def __len__(self) -> int:
        return len(self._recordings)

    @property
    def first(self) -> Recording:
        """The recording of the first scenario: enough for facts that are the same in every run."""
        return next(iter(self._recordings.values()))

    def scenario(self, name: str) -> Scenario:
        """The scenario of that name: its arguments, duration and seed."""
        return self._scenarios[name]

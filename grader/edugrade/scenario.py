"""One run that a rubric asks for."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Scenario(NamedTuple):
    """A named launch of the submission.

    :param arguments: launch arguments, as in ``ros2 launch file name:=value``.
    :param duration_s: simulated seconds.
    :param seed: of the simulation; it decides the randomness of the students' nodes. 0: the rubric's seed decides it.
    """

    name: str
    arguments: Mapping[str, str] = MappingProxyType({})
    duration_s: float = 20.0
    seed: int = 0

    @property
    def command(self) -> str:
        """The arguments as they are typed after ``ros2 launch``."""
        return ' '.join(f'{name}:={value}' for name, value in self.arguments.items())

    @property
    def words(self) -> str:
        """The arguments, or that there are none: for sentences."""
        return self.command or 'no arguments'

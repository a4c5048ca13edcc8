"""An index for which every package exists."""

from __future__ import annotations

import os

from edulaunch.packages import Index
from edulaunch.packages.image import Image
from edulaunch.plan.assumptions import Assumptions


class AssumingIndex(Index):
    """Another index, with an empty placeholder for each package that it lacks, and every executable.

    Placeholders stand in a temporary folder that goes away with this object.

    :param real: the index that is asked first.
    :ivar assumptions: what was missing.
    """

    def __init__(self, real: Index) -> None:
        super().__init__((), (), underlay=None)
        self._places = [*real._places]
        self._image = Image('placeholders')
        self.assumptions = Assumptions(self._image.path)

    def search_paths(self) -> list[str]:
        """The real ones, and the placeholders' last."""
        return [*super().search_paths(), self._image.path]

    def prefix(self, package: str) -> str:
        """The package's prefix, or that of the placeholders."""
        found = super().prefix(package)
        if found is not None:
            return found
        self.assumptions.package(package)
        self._image.add_folder(os.path.join('share', package))
        return self._image.path

    def find_executable(self, package: str, executable: str) -> str:
        """Where the executable would be; nothing is looked up."""
        return os.path.join(self.prefix(package), 'lib', package, executable)

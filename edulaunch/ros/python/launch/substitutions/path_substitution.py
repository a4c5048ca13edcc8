"""The substitution `PathSubstitution`."""

from __future__ import annotations

from ..substitution import SomeSubstitutionsType, Substitution
from .path_join_substitution import PathJoinSubstitution
from .string_join_substitution import StringJoinSubstitution


class PathSubstitution(PathJoinSubstitution):
    """A path whose parts are joined with `/`, as in pathlib: `PathSubstitution(FindPackageShare('p')) / 'launch' / ['robot_',
    name, '.launch.py']`.

    The class is newer than Jazzy's first release. It is included for files that use it.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__([path] if isinstance(path, (str, Substitution)) else path)

    def __truediv__(self, part: SomeSubstitutionsType) -> PathSubstitution:
        """Return the path with one more part. The items of a list are joined into one part first."""
        whole = part if isinstance(part, (str, Substitution)) else StringJoinSubstitution(part)
        return PathSubstitution([*self.substitutions, whole])

"""The process behind each row of a recording, and the program of each hosted process, as determined by the trusted peer.

Names in a recording come from the submission, and two processes can have the same name. Positions in the recording are
reliable.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording

PARTS = ('nodes', 'parameters', 'logs', 'output')


class HostedProgram(NamedTuple):
    """The package and the executable of a program that the trusted peer ran itself."""

    package: str
    executable: str


class Provenance:
    """The origin of the rows of a recording.

    :ivar owners: for each of PARTS, the position in `processes` of the process behind each row; -1 means no process.
    :ivar programs: the programs that the trusted peer ran itself, by position in `processes`.
    """

    def __init__(self) -> None:
        self.owners: dict[str, list[int]] = {part: [] for part in PARTS}
        self.programs: dict[int, HostedProgram] = {}

    def as_data(self) -> list[Any]:
        """Return the content as plain data for JSON; :func:`attach` reads it."""
        return [self.owners, [[position, *program] for position, program in self.programs.items()]]


def attach(recording: Recording, data: Any) -> None:
    """Attach the provenance from `Provenance.as_data` to a recording.

    :raises KeyError, TypeError, ValueError: for data in another form.
    """
    owners, programs = data
    recording.owners = {part: [int(owner) for owner in owners[part]] for part in PARTS}
    recording.hosted = {int(position): HostedProgram(package, executable) for position, package, executable in programs}

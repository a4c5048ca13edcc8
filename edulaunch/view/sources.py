"""What a film can be made from: the recorder of a machine that lives, or a recording."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.view.advice import marks_of
from edulaunch.view.film import Film

if TYPE_CHECKING:
    from edulaunch.recording import Recorder, Recording

_PARTS = {'output': 'output_lines'}


def film_of(recording: Recording) -> dict[str, Any]:
    """All of a recording as one piece of film, with what the rules say of it."""
    film = Film(OfRecording(recording))
    film.mark(marks_of(recording))
    return film.piece()


class OfRecording:
    """A finished recording as the source of a film: equal on every machine, for paths of this one are left out."""

    def __init__(self, recording: Recording) -> None:
        from edulaunch.recording.canonical import canonical

        self._content = canonical(recording._content)
        self._class = recording._class
        self._topics = {(column['topic'], column['type']): column for column in self._content['topics']}

    def topics(self) -> list[tuple[str, str]]:
        """(topic, type) of all there are."""
        return list(self._topics)

    def rows(self, topic: str, kind: str, first: int) -> tuple[Sequence[int], Sequence[int], Sequence[Any]]:
        """See `Source.rows`."""
        column = self._topics[topic, kind]
        return column['times'][first:], column['publishers'][first:], column['messages'][first:]

    def part(self, name: str) -> Sequence[Any]:
        """See `Source.part`."""
        rows: Sequence[Any] = self._content.get(name) or ()
        return rows

    def forgotten(self, what: object) -> int:
        """A recording has everything."""
        return 0

    def wire_type(self, kind: str) -> Sequence[tuple[str, str]]:
        """See `Source.wire_type`."""
        entries: Sequence[tuple[str, str]] = self._class(kind).wire_type()
        return entries

    def start_ns(self) -> int:
        """See `Source.start_ns`."""
        start: int = self._content['start_ns']
        return start

    def now_ns(self) -> int:
        """The length of the recording."""
        duration: int = self._content['duration_ns']
        return duration


class OfRecorder:
    """The recorder of a machine that goes on running as the source of a film."""

    def __init__(self, recorder: Recorder) -> None:
        self._recorder = recorder

    def topics(self) -> list[tuple[str, str]]:
        """(topic, type) of all there are, in alphabetical order."""
        return sorted(self._recorder.columns)

    def rows(self, topic: str, kind: str, first: int) -> tuple[Sequence[int], Sequence[int], Sequence[Any]]:
        """See `Source.rows`."""
        flat = self._recorder.columns[topic, kind]
        start, at = self._recorder.sim.start_ns, 3 * (first - self.forgotten((topic, kind)))
        return [time - start for time in flat[at::3]], flat[at + 1 :: 3], flat[at + 2 :: 3]

    def forgotten(self, what: object) -> int:
        """See `Source.forgotten`."""
        return self._recorder.forgotten.get(_PARTS.get(what, what) if isinstance(what, str) else what, 0)

    def part(self, name: str) -> Sequence[Any]:
        """See `Source.part`."""
        rows: Sequence[Any] = getattr(self._recorder, _PARTS.get(name, name))
        return rows

    def wire_type(self, kind: str) -> Sequence[tuple[str, str]]:
        """See `Source.wire_type`."""
        from edulaunch.interfaces import current_registry

        overlay = self._recorder.overlay
        registry = overlay.registry if overlay is not None else current_registry()
        entries: Sequence[tuple[str, str]] = registry.get(kind).wire_type()
        return entries

    def start_ns(self) -> int:
        """See `Source.start_ns`."""
        return self._recorder.sim.start_ns

    def now_ns(self) -> int:
        """Simulated time since the start."""
        return self._recorder.sim.now_ns - self._recorder.sim.start_ns

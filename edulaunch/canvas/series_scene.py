"""Numbers of a topic over time, as plain data."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.recording.absent import NothingToDraw, not_recorded

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording


class SeriesScene(NamedTuple):
    """Lines by the field that they show: points of (time in seconds, value)."""

    topic: str
    duration_s: float
    lines: list[tuple[str, list[tuple[float, float]]]]

    def caption(self) -> str:
        """One line that says what is to be seen."""
        told = (f'{field} from {points[0][1]:.3f} to {points[-1][1]:.3f}' for field, points in self.lines)
        return f'{self.topic}: {", ".join(told)}'


def series_scene(recording: Recording, topic: str, fields: tuple[str, ...]) -> SeriesScene:
    """The fields of a topic over time.

    :raises NotRecorded: when there is no such topic or field; the message names the nearest one.
    :raises NothingToDraw: when nothing was published there, or a field is no number.
    """
    if topic not in recording.topics:
        raise not_recorded(f'no topic {topic!r}', topic, recording.topics)
    rows = recording.series(topic, *fields)
    if not rows:
        raise NothingToDraw(f'nothing was published on {topic}')
    for field, value in zip(fields, rows[0][1:], strict=True):
        if not isinstance(value, (int, float)):
            raise NothingToDraw(f'{field!r} of {topic} is no number but {type(value).__name__}: it cannot be plotted')
    lines = [(field, [(row[0], float(row[place])) for row in rows]) for place, field in enumerate(fields, 1)]
    return SeriesScene(topic, recording.duration_s, lines)

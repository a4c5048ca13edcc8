"""The two sources of a timeline, and the replay of a run, which is a live view without a machine."""

from __future__ import annotations

import html
import os
from base64 import b64encode
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from edulaunch.canvas.filmstrip import filmstrip
from edulaunch.canvas.picture import scene_data
from edulaunch.canvas.worlds import World, read_worlds
from edulaunch.desk.view.launch_outline import launch_outline
from edulaunch.desk.view.launches import in_microseconds, launches_of
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.timeline import Timeline, marks_of
from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.recording import views

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recorder, Recording

_PARTS = {'output': 'output_lines'}
HEIGHT_PX = 780
SCHEME = (
    '<style>[data-jp-theme-light="true"] .edulaunch-replay iframe{color-scheme:light}'
    '[data-jp-theme-light="false"] .edulaunch-replay iframe{color-scheme:dark}</style>'
)
"""JupyterLab sets the theme of a replay: the page in the frame uses the colour scheme of its element."""
MOVING = ('turtlesim/msg/Pose', 'nav_msgs/msg/Odometry')


def timeline_of(recording: Recording, other: Recording | None = None) -> dict[str, Any]:
    """Return a whole recording as one timeline delta, with the findings of the rules.

    :param recording: the recording.
    :param other: another recording, which the page plots for comparison, or None.
    """
    from edulaunch.desk.view.defaults import defaults_of  # imported here, because only the page of an ended run needs it

    source = RecordingSource(recording)
    timeline = Timeline(source)
    timeline.mark(marks_of(recording))
    delta = timeline.delta()
    if defaults := defaults_of(source.part('nodes'), source.part('processes'), source.part('parameters')):
        delta['defaults'] = defaults
    return delta if other is None else {**delta, 'other': Timeline(RecordingSource(other)).delta()}


def outline_of(recording: Recording) -> str:
    """Return the launch of a recording as HTML without scripts, in the state at the end of the run. Return an empty string if
    there was no launch.
    """
    source = RecordingSource(recording)
    return launch_outline([in_microseconds(trace) for trace in source.beside('launches', {})], source.now_ns() // 1000)


class RecordingSource:
    """A finished recording as the source of a timeline.

    It contains no paths of this computer, so it is equal on all computers.
    """

    def __init__(self, recording: Recording) -> None:
        from edulaunch.engine.recording.canonical import canonical

        for column in recording.rows('topics'):
            recording.wires(column['topic'], column['type'])  # rejects messages of a damaged file
        self._content = canonical(recording._content)
        self._lines = recording.lines
        self._class = recording.message_class
        self._topics = {(column['topic'], column['type']): column for column in self._content['topics']}

    def topics(self) -> list[tuple[str, str]]:
        """Return the (name, type) of each topic."""
        return list(self._topics)

    def rows(self, topic: str, kind: str, first: int) -> tuple[Sequence[int], Sequence[int], Sequence[Any]]:
        """Implement `TimelineSource.rows`."""
        column = self._topics[topic, kind]
        return column['times'][first:], column['publishers'][first:], column['messages'][first:]

    def part(self, name: str) -> Sequence[Any]:
        """Implement `TimelineSource.part`."""
        rows: Sequence[Any] = self._content.get(name) or ()
        return rows

    def numbers(self, name: str) -> Sequence[int]:
        """Return 0, 1, 2, and so on, because a recording has dropped no rows."""
        return range(len(self.part(name)))

    def forgotten(self, topic: tuple[str, str]) -> int:
        """Return 0, because a recording has dropped no messages."""
        return 0

    def lines(self) -> Mapping[int, tuple[str, int]]:
        """Implement `TimelineSource.lines`. A recording from a file does not store these lines."""
        return self._lines

    def beside(self, name: str, since: Mapping[int, int]) -> Sequence[dict[str, Any]]:
        """Implement `TimelineSource.beside`."""
        return list(launches_of(self._content['beside'].get(name)))

    def wire_type(self, kind: str) -> Sequence[tuple[str, str]]:
        """Implement `TimelineSource.wire_type`."""
        entries: Sequence[tuple[str, str]] = self._class(kind).wire_type()
        return entries

    def start_ns(self) -> int:
        """Implement `TimelineSource.start_ns`."""
        start: int = self._content['start_ns']
        return start

    def now_ns(self) -> int:
        """Return the length of the recording in nanoseconds."""
        duration: int = self._content['duration_ns']
        return duration


class RecorderSource:
    """The recorder of a running machine, as the source of a timeline."""

    def __init__(self, recorder: Recorder) -> None:
        self._recorder = recorder

    def topics(self) -> list[tuple[str, str]]:
        """Return the (name, type) of each topic, in alphabetical order."""
        return sorted(self._recorder.columns)

    def rows(self, topic: str, kind: str, first: int) -> tuple[Sequence[int], Sequence[int], Sequence[Any]]:
        """Implement `TimelineSource.rows`."""
        flat = self._recorder.columns[topic, kind]
        start, at = self._recorder.sim.start_ns, 3 * (first - self.forgotten((topic, kind)))
        return [time - start for time in flat[at::3]], flat[at + 1 :: 3], flat[at + 2 :: 3]

    def numbers(self, name: str) -> Sequence[int]:
        """Implement `TimelineSource.numbers`."""
        return self._recorder.numbers(_PARTS.get(name, name))

    def forgotten(self, topic: tuple[str, str]) -> int:
        """Implement `TimelineSource.forgotten`."""
        return self._recorder.forgotten.get(topic, 0)

    def lines(self) -> Mapping[int, tuple[str, int]]:
        """Implement `TimelineSource.lines`."""
        return self._recorder.lines

    def beside(self, name: str, since: Mapping[int, int]) -> Sequence[dict[str, Any]]:
        """Implement `TimelineSource.beside`."""
        return [one.as_data(since.get(one.pid, 0)) for one in self._recorder.beside.get(name, ())]

    def part(self, name: str) -> Sequence[Any]:
        """Implement `TimelineSource.part`."""
        rows: Sequence[Any] = getattr(self._recorder, _PARTS.get(name, name))
        return rows

    def wire_type(self, kind: str) -> Sequence[tuple[str, str]]:
        """Implement `TimelineSource.wire_type`."""
        overlay = self._recorder.overlay
        registry = overlay.registry if overlay is not None else current_registry()
        entries: Sequence[tuple[str, str]] = registry.get(kind).wire_type()
        return entries

    def start_ns(self) -> int:
        """Implement `TimelineSource.start_ns`."""
        return self._recorder.sim.start_ns

    def now_ns(self) -> int:
        """Return the simulated time since the start in nanoseconds."""
        return self._recorder.sim.now_ns - self._recorder.sim.start_ns


class Replay:
    """The replay of a whole run in a live view, with turtles, frames, the graph, plots, the log and parameters.

    Notebooks, and HTML pages made from notebooks, show the live view. If scripts cannot run, they show a strip of small pictures.
    `repr()` returns one line. The output also contains a digest of all movements, which tests of notebooks compare.

    :param recording: the recording to replay.
    :param other: another recording, which the page plots for comparison, or None.
    :raises NothingToDraw: when nothing moved in the recording.
    """

    def __init__(self, recording: Recording, other: Recording | None = None) -> None:
        self._worlds: list[World] = read_worlds(recording)
        self._title = os.path.basename(recording.launch.file or '') or 'replay'
        self.duration_s = recording.duration_s
        self.timeline: dict[str, Any] = timeline_of(recording, other)

    @property
    def caption(self) -> str:
        """Return one line that describes the replay."""
        worlds = []
        for world in self._worlds:
            names = ', '.join(dict.fromkeys(track.name for track in world.tracks))
            worlds.append(f'{world.title} with {names or "nobody"}')
        return f'replay of {self.duration_s:.2f} s: {"; ".join(worlds)}'

    def __repr__(self) -> str:
        return self.caption

    def filmstrip(self) -> str:
        """Return a strip of small pictures of the run as SVG."""
        return filmstrip(self._worlds, self.duration_s)

    def page(self, *, small: bool = True) -> str:
        """Return the live view as an HTML page that needs no other file.

        :param small: whether to compress the data. If False, the bytes are the same for all versions of zlib.
        """
        return recorded_page(self.timeline, self._title, small=small)

    def html(self) -> str:
        """Return the output for a notebook: an isolated frame with the live view, above a picture for places without scripts."""
        alternative, picture = html.escape(self.caption), b64encode(self.filmstrip().encode()).decode()
        return (
            f'{SCHEME}<div class="edulaunch-replay" style="position:relative;height:{HEIGHT_PX}px;overflow:hidden">'
            f'<img alt="{alternative}" style="max-width:100%;max-height:100%;object-fit:contain" '
            f'src="data:image/svg+xml;base64,{picture}">'
            f'<iframe title="{alternative}" sandbox="allow-scripts" '
            f'style="position:absolute;inset:0;width:100%;height:100%;border:0" '
            f'srcdoc="{_in_quotes(self.page(small=False))}"></iframe></div>'
        )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        moved = [topic for topic in self.timeline['topics'] if topic['type'] in MOVING]
        return {'text/plain': repr(self), 'text/html': self.html(), **scene_data([moved, self.timeline.get('tf')])}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the live view as an HTML file that any browser can replay without a network."""
        Path(path).write_text(self.page(), encoding='utf-8')


def _in_quotes(text: str) -> str:
    """Return a string as the value of an attribute in double quotes.

    Only two characters are escaped, because a page contains thousands of the others.
    """
    return text.replace('&', '&amp;').replace('"', '&quot;')


views.register(replay=Replay)

"""What a run looked like, as HTML: the picture at its end, and the replay."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from typing import TYPE_CHECKING

from .markup import Markup, element
from .outcome import Outcome

if TYPE_CHECKING:
    from edulaunch.recording import Recording


def run_html(outcome: Outcome, is_open: bool) -> Markup:
    """One run under a heading that unfolds: how it was launched, and what could be seen."""
    scenario = outcome.scenario
    heading = f'Run "{scenario.name}": {scenario.duration_s:g} s, launched with {scenario.words}'
    inside = [element('p', outcome.text)] if outcome.recording is None else list(_seen(outcome.recording))
    attributes = {'open': ''} if is_open else {}
    return element('details', element('summary', heading), *inside, **attributes)


def _seen(recording: Recording) -> Iterator[Markup]:
    picture = _picture(recording)
    if picture is not None:
        yield picture
    replay = _replay(recording)
    if replay is not None:
        yield replay
    yield element('p', f'recording {recording.digest()[:12]}', class_='small')


def _picture(recording: Recording) -> Markup | None:
    """The turtles at the end of the run; the frames when nothing moved, the nodes when there are no frames either."""
    for plot in (recording.plot_turtles, recording.plot_frames, recording.plot_graph):
        try:
            picture = plot()
        except ValueError:  # the view says that there is nothing for it to show
            continue
        data = base64.b64encode(picture.png()).decode('ascii')
        image = element('img', src=f'data:image/png;base64,{data}', alt=repr(picture))
        return element('figure', image, element('figcaption', picture.caption))
    return None


def _replay(recording: Recording) -> Markup | None:
    """The player, which stands in a frame of its own: it can reach neither this page nor the network."""
    try:
        player = recording.replay()
    except ValueError:  # nothing moved
        return None
    return Markup(player.html())

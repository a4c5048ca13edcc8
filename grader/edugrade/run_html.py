"""What a run looked like, as HTML: the picture at its end, and the replay."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from typing import TYPE_CHECKING

from .cpu_limit import cpu_limit
from .markup import Markup, element, joined
from .outcome import Outcome
from .worker import Exceeded, Lost, in_worker

if TYPE_CHECKING:
    from edulaunch.recording import Recording

LONGEST_DRAWING_S = 10.0  # usual: 0.2 s


def run_html(outcome: Outcome, is_open: bool) -> Markup:
    """One run under a heading that unfolds: how it was launched, and what could be seen."""
    scenario = outcome.scenario
    heading = f'Run "{scenario.name}": {scenario.duration_s:g} s, launched with {scenario.words}'
    inside = element('p', outcome.text) if outcome.recording is None else _drawn(outcome.recording)
    attributes = {'open': ''} if is_open else {}
    return element('details', element('summary', heading), inside, **attributes)


def _drawn(recording: Recording) -> Markup:
    """What can be seen, drawn by a worker: a run that cannot be drawn costs nobody the page."""
    try:
        return Markup(in_worker(lambda: joined(*_seen(recording))))
    except (Exceeded, Lost, RuntimeError) as error:
        return _not_drawn('picture', error)


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
            with cpu_limit(LONGEST_DRAWING_S):
                picture = plot()
                png = picture.png()
            data = base64.b64encode(png).decode('ascii')
        except ValueError:  # the view says that there is nothing for it to show
            continue
        except Exception as error:  # such as a ring of frames: one run that cannot be drawn costs nobody the page
            return _not_drawn('picture', error)
        image = element('img', src=f'data:image/png;base64,{data}', alt=repr(picture))
        return element('figure', image, element('figcaption', picture.caption))
    return None


def _replay(recording: Recording) -> Markup | None:
    """The player, which stands in a frame of its own: it can reach neither this page nor the network."""
    try:
        with cpu_limit(LONGEST_DRAWING_S):
            return Markup(recording.replay().html())
    except ValueError:  # nothing moved
        return None
    except Exception as error:
        return _not_drawn('replay', error)


def _not_drawn(view: str, error: Exception) -> Markup:
    why = f'{error.name} is not installed here' if isinstance(error, ModuleNotFoundError) else type(error).__name__
    return element('p', f'The {view} of this run could not be drawn: {why}.', class_='small')

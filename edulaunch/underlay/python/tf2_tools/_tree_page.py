"""The tree of frames on a PDF page, as view_frames shows it."""

from __future__ import annotations

from io import BytesIO
from typing import Any

COLUMN, ROW = 3.6, 2.2
"""Inches that a frame takes, with the facts on the arrow above it."""


def prepare() -> None:
    """Load what draws now, so that drawing is a short turn of its own."""
    import matplotlib.backends.backend_pdf
    import matplotlib.figure  # noqa: F401


def draw_pdf(data: dict[Any, dict[str, Any]], recorded_time: float, path: str) -> None:
    """Draw parents above their children; on each arrow stand broadcaster, rate, buffer length and the age of transforms.

    :param data: by child frame, as `all_frames_as_yaml` describes them.
    """
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    places, levels = _places(data)
    width = max((x for x, _ in places.values()), default=0.0) + 1.0
    figure = Figure(figsize=(max(4.0, width * COLUMN), 1.2 + levels * ROW))
    FigureCanvasPdf(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(-0.5, width - 0.5)
    axes.set_ylim(-levels - 0.1, 0.8)
    for child, facts in data.items():
        (x, y), (above_x, above_y) = places[child], places[facts['parent']]
        axes.annotate('', (x, y + 0.14), (above_x, above_y - 0.14), arrowprops={'arrowstyle': '-|>', 'color': 'black'})
        axes.text(
            (x + above_x) / 2, (y + above_y) / 2, _facts(facts), ha='center', va='center', fontsize=8, backgroundcolor='white'
        )
    for name, (x, y) in places.items():
        box = {'boxstyle': 'round4,pad=0.5', 'facecolor': 'white', 'edgecolor': 'black'}
        axes.text(x, y, str(name), ha='center', va='center', fontsize=11, bbox=box)
    title = f'view_frames Result\nRecorded at time: {recorded_time}'
    axes.text(width / 2 - 0.5, 0.75, title if data else 'No tf data received', ha='center', va='top', fontsize=10)
    page = BytesIO()  # matplotlib's own files would lie in the folder of the real program
    figure.savefig(page, format='pdf', metadata={'CreationDate': None})
    with open(path, 'wb') as file:
        file.write(page.getvalue())


def _facts(facts: dict[str, Any]) -> str:
    return (
        f'Broadcaster: {facts["broadcaster"]}\nAverage rate: {facts["rate"]}\nBuffer length: {facts["buffer_length"]}\n'
        f'Most recent transform: {facts["most_recent_transform"]}\nOldest transform: {facts["oldest_transform"]}'
    )


def _places(data: dict[Any, dict[str, Any]]) -> tuple[dict[Any, tuple[float, float]], int]:
    """Column and height of each frame (leaves stand side by side, a parent over the middle of its children), and the levels."""
    children: dict[Any, list[Any]] = {}
    for child, facts in data.items():
        children.setdefault(facts['parent'], []).append(child)
    places: dict[Any, tuple[float, float]] = {}
    column = 0.0
    waiting = [(root, 0, False) for root in children if root not in data][::-1]
    while waiting:
        frame, level, is_done = waiting.pop()
        below = children.get(frame, ())
        if below and not is_done:
            waiting += [(frame, level, True), *((child, level + 1, False) for child in reversed(below))]
            continue
        places[frame] = (sum(places[child][0] for child in below) / len(below) if below else column, float(-level))
        column += 0.0 if below else 1.0
    return places, 1 + max((int(-height) for _, height in places.values()), default=0)

"""A planned or recorded system of nodes, topics and frames as a scene, or two systems side by side with their differences marked.

A system is a `System` of `edulaunch.advice.explaining.systems`, or any object with the attributes `title`, `nodes` and
`frames`. Two systems share one layout, so that equal boxes have equal places.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from edulaunch.canvas.layout import Point, lay_out
from edulaunch.canvas.style import SMALL, TEXT, mono_width, shortened

Key = tuple[str, str]
"""Kind ('node', 'topic', 'service' or 'frame') and name."""
ADDED, GONE, CHANGED, SAME = '+', '-', '~', ''
LINE, MOST_NOTES = 14.0, 4
NAMES = {'node': 'nodes', 'topic': 'topics', 'service': 'services', 'frame': 'frames'}
HIDDEN = ('/rosout', '/parameter_events')


class SystemBox(NamedTuple):
    """A box with its upper left corner and size in pixels.

    :ivar notes: the lines below the name.
    :ivar unknown: whether a part of the box is not known.
    :ivar sign: the difference from the second system: '+', '-', '~', or ''.
    """

    kind: str
    name: str
    notes: list[str]
    unknown: bool
    sign: str
    left: float
    top: float
    width: float
    height: float


class Panel(NamedTuple):
    """One system: its title, its boxes, its arrows as pairs of indices into the boxes, and the path and the sign of each
    arrow.
    """

    title: str
    boxes: list[SystemBox]
    arrows: list[tuple[int, int]]
    routes: list[list[Point]]
    signs: list[str]


class SystemScene(NamedTuple):
    """One or two panels of equal size."""

    width: float
    height: float
    direction: str
    panels: list[Panel]

    def caption(self) -> str:
        """Return a description of the picture."""
        return '; '.join(_panel_words(panel) for panel in self.panels)


def _panel_words(panel: Panel) -> str:
    count = {kind: sum(box.kind == kind for box in panel.boxes) for kind in NAMES}
    counted = ', '.join(f'{count[kind]} {NAMES[kind]}' for kind in count if count[kind]) or 'nothing'
    notes = [f'{box.name}: {note}' for box in panel.boxes if box.kind != 'frame' for note in box.notes]
    signed = [f'{box.sign} {box.name}' for box in panel.boxes if box.sign]
    return '; '.join([f'{panel.title}: {counted}', *notes, *signed])


class _Parts(NamedTuple):
    """The parts of one system: its boxes, each with its notes and whether it is unknown, and its arrows."""

    boxes: dict[Key, tuple[list[str], bool]]
    arrows: list[tuple[Key, Key]]


def system_scene(
    system: Any, other: Any = None, changed: Mapping[str, list[str]] | None = None, *, services: bool = False
) -> SystemScene:
    """Return a scene with one system, or with two systems in the same layout.

    :param changed: for each node in both systems, the names of the parameters whose values differ.
    :param services: whether to show services that a node calls.
    """
    systems = [system] if other is None else [system, other]
    parts = [_parts(one, services, changed or {}) for one in systems]
    keys = list(dict.fromkeys(key for part in parts for key in part.boxes))
    arrows = list(dict.fromkeys(arrow for part in parts for arrow in part.arrows))
    sizes = dict.fromkeys(keys, (0.0, 0.0))
    for part in parts:
        for key, (notes, _) in part.boxes.items():
            sizes[key] = max(sizes[key][0], _size(key, notes)[0]), max(sizes[key][1], _size(key, notes)[1])
    place = {key: number for number, key in enumerate(keys)}
    layout = lay_out(list(sizes.values()), [(place[start], place[end]) for start, end in arrows])
    marks = {('node', name) for name in changed or ()}
    panels = []
    for number, part in enumerate(parts):
        others = None if other is None else parts[1 - number]
        placed = [(key, layout.corners[place[key]], sizes[key]) for key in part.boxes]
        ways = {arrow: route.points for arrow, route in zip(arrows, layout.routes, strict=True)}
        panels.append(_panel(systems[number].title, part, others, GONE if number == 0 else ADDED, marks, placed, ways))
    return SystemScene(layout.width, layout.height, layout.direction, panels)


def _panel(
    title: str,
    part: _Parts,
    others: _Parts | None,
    sign: str,
    marks: set[Key],
    placed: list[tuple[Key, Point, tuple[float, float]]],
    ways: dict[tuple[Key, Key], list[Point]],
) -> Panel:
    boxes = []
    for key, corner, size in placed:
        its_sign = sign if others is not None and key not in others.boxes else CHANGED if key in marks else SAME
        boxes.append(SystemBox(*key, *part.boxes[key], its_sign, *corner, *size))
    here = {key: position for position, key in enumerate(part.boxes)}
    arrows = [(here[start], here[end]) for start, end in part.arrows]
    signs = [sign if others is not None and arrow not in others.arrows else SAME for arrow in part.arrows]
    return Panel(title, boxes, arrows, [ways[arrow] for arrow in part.arrows], signs)


def _parts(system: Any, services: bool, changed: Mapping[str, list[str]]) -> _Parts:
    boxes: dict[Key, tuple[list[str], bool]] = {}
    for node in system.nodes:
        values = [f'{name} = {node.parameters.get(name, "not set")}' for name in changed.get(node.name, ())]
        boxes['node', node.name] = [*(f'? {words}' for words in node.unknown), *values][:MOST_NOTES], bool(node.unknown)
    arrows: list[tuple[Key, Key]] = []
    guess = '' if all(node.source == 'run' for node in system.nodes) else ' known'
    for kind, giver, taker in (('topic', 'publisher', 'subscription'), ('service', 'client', 'service')):
        ends: dict[str, tuple[list[Key], list[Key]]] = {}
        for node in system.nodes:
            for what, name, _ in node.ends:
                if what in (giver, taker):
                    ends.setdefault(name, ([], []))[what == taker].append(('node', node.name))
        for name, (givers, takers) in ends.items():
            if name in HIDDEN or (kind == 'service' and not (services and givers)):
                continue
            is_lonely = kind == 'topic' and not (givers and takers) and name != '/tf_static'
            boxes[kind, name] = ([f'no {taker if givers else giver}{guess}'] if is_lonely else []), is_lonely
            arrows += [(giver_key, (kind, name)) for giver_key in givers] + [((kind, name), taker_key) for taker_key in takers]
    for frame in system.frames:
        boxes.setdefault(('frame', frame.parent), ([], False))
        boxes['frame', frame.child] = ([*(['static'] if frame.is_static else []), *(f'by {node}' for node in frame.by)], False)
        arrows.append((('frame', frame.parent), ('frame', frame.child)))
    return _Parts(boxes, list(dict.fromkeys(arrows)))


def lines_of(kind: str, name: str, notes: list[str]) -> list[tuple[str, float, bool]]:
    """Return the lines of a box, as (text, font size, whether it is a note). The namespace is above the name, in small type."""
    namespace, _, base = name.rpartition('/')
    lines = [(shortened(namespace + '/'), SMALL, False)] if namespace else []
    lines.append((shortened(base if namespace else name), TEXT, False))
    if kind in ('service', 'frame'):
        lines.append((f'({kind})', SMALL, False))
    return [*lines, *((shortened(note, 40), SMALL, True) for note in notes)]


def _size(key: Key, notes: list[str]) -> tuple[float, float]:
    lines = lines_of(*key, notes)
    width = max(mono_width(text, size) for text, size, _ in lines) + (38 if key[0] == 'node' else 28)
    return (float(round(width)), 12.0 + LINE * len(lines))

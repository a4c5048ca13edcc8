"""The node graph and the tf tree of a run, arranged on a sheet, as plain data."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.layout import WIDEST, Point, lay_out
from edulaunch.canvas.style import SMALL, TEXT, mono_width, shortened
from edulaunch.engine.recording.absent import NothingToDraw
from edulaunch.engine.recording.records import PARAMETER_SERVICES

if TYPE_CHECKING:
    from edulaunch.engine.recording.frames import FrameLink
    from edulaunch.engine.recording.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord

HIDDEN = ('/rosout', '/parameter_events')
Key = tuple[str, str, int]
"""Kind ('node', 'topic' or 'service'), name, and a number that distinguishes nodes of that name."""
LINE = 14.0


class Box(NamedTuple):
    """A node, topic or service, with the upper left corner and the size of its box in pixels. `mark` names a problem, or is
    ''.
    """

    kind: str
    name: str
    left: float
    top: float
    width: float
    height: float
    mark: str


class GraphScene(NamedTuple):
    """The boxes, the arrows as pairs of indices into the boxes, and the path of each arrow (see
    `edulaunch.canvas.layout.Route`).
    """

    width: float
    height: float
    boxes: list[Box]
    arrows: list[tuple[int, int]]
    routes: list[list[Point]]
    direction: str

    def caption(self) -> str:
        """Return one line that describes the scene."""
        count = {kind: sum(box.kind == kind for box in self.boxes) for kind in ('node', 'topic', 'service')}
        marked = [f'{box.name}: {box.mark}' for box in self.boxes if box.mark]
        services = f', {count["service"]} services' if count['service'] else ''
        text = f'{count["node"]} nodes, {count["topic"]} topics{services}, {len(self.arrows)} connections'
        return text + (f'; {"; ".join(marked)}' if marked else '')


def graph_scene(recording: Recording, *, unused: bool = False, services: bool = False) -> GraphScene:
    """Return the graph at the end of a run.

    As in `rqt_graph`, nodes that have ended are missing. If all nodes have ended, the graph shows all of them.

    :param unused: whether to show topics without subscriptions.
    :param services: whether to show services with clients.
    """
    nodes = _shown(recording)
    edges, marks = _topics(recording, nodes, unused)
    if services:
        calls, unserved = _services(nodes)
        edges, marks = edges + calls, {**marks, **unserved}
    marks |= {key: 'two nodes have this name' for key in nodes if ('node', key[1], 1) in nodes}
    keys = list(dict.fromkeys([*nodes, *(key for edge in edges for key in edge)]))
    place = {key: number for number, key in enumerate(keys)}
    arrows = list(dict.fromkeys((place[start], place[end]) for start, end in edges))
    sizes = [_size(kind, name, marks.get((kind, name, which), '')) for kind, name, which in keys]
    layout = lay_out(sizes, arrows)
    boxes = [
        Box(*key[:2], *corner, *size, marks.get(key, '')) for key, corner, size in zip(keys, layout.corners, sizes, strict=True)
    ]
    return GraphScene(layout.width, layout.height, boxes, arrows, [route.points for route in layout.routes], layout.direction)


def _shown(recording: Recording) -> dict[Key, NodeRecord]:
    """Return the nodes that exist at the end or, if all nodes have ended, all nodes. Nodes with equal names that exist at the
    same time stay separate.
    """
    nodes = [node for node in recording.nodes if not node.name.rpartition('/')[2].startswith('_')]
    alive = [node for node in nodes if node.ended_s is None]
    if not alive:  # if a node was started again, the graph contains only its last life
        alive = [
            node for node in nodes if not any(node.name == other.name and _ended(node) <= other.started_s for other in nodes)
        ]
    count: Counter[str] = Counter()
    found: dict[Key, NodeRecord] = {}
    for node in alive:
        found['node', node.name, count[node.name]] = node
        count[node.name] += 1
    return found


def _ended(node: NodeRecord) -> float:
    return math.inf if node.ended_s is None else node.ended_s


def _topics(recording: Recording, nodes: Mapping[Key, NodeRecord], unused: bool) -> tuple[list[tuple[Key, Key]], dict[Key, str]]:
    """Return the arrows from publishers to topics and from topics to subscriptions, and the problems of topics."""
    edges: list[tuple[Key, Key]] = []
    marks: dict[Key, str] = {}
    mismatches = {mismatch.topic: mismatch.why.lower() for mismatch in recording.mismatches}
    for topic in recording.topics:
        publishers = [key for key, node in nodes.items() if topic in dict(node.publishers)]
        subscribers = [key for key, node in nodes.items() if topic in dict(node.subscriptions)]
        if topic in HIDDEN or not (subscribers or (unused and publishers)):
            continue
        key = ('topic', topic, 0)
        edges += [(node, key) for node in publishers] + [(key, node) for node in subscribers]
        if topic == '/tf_static' and not (publishers and subscribers):
            continue  # every tf listener subscribes to it, so a missing publisher (no static frames) is not a mistake
        if not publishers:
            marks[key] = 'no publisher'
        elif not subscribers:
            marks[key] = 'no subscriber'
        elif topic in mismatches:
            marks[key] = f'{mismatches[topic]} does not fit'
    return edges, marks


def _services(nodes: Mapping[Key, NodeRecord]) -> tuple[list[tuple[Key, Key]], dict[Key, str]]:
    """Return the arrows from clients to services and from services to servers, and the services without a server."""
    servers = {name: key for key, node in nodes.items() for name, _ in node.services}
    edges: list[tuple[Key, Key]] = []
    marks: dict[Key, str] = {}
    for client, node in nodes.items():
        for name, _ in node.clients:
            key = ('service', name, 0)
            if name.rpartition('/')[2] not in PARAMETER_SERVICES:
                edges.append((client, key))
                if name in servers:
                    edges.append((key, servers[name]))
                else:
                    marks[key] = 'no server'
    return edges, marks


def label_lines(kind: str, name: str, mark: str) -> list[tuple[str, float, bool]]:
    """Return the content of a box as (text, font size, whether it is the mark). The namespace is above the name, in small
    type.
    """
    namespace, _, base = name.rpartition('/')
    lines = [(shortened(namespace + '/'), SMALL, False)] if namespace else []
    lines.append((shortened(base if namespace else name), TEXT, False))
    if kind == 'service':
        lines.append(('(service)', SMALL, False))
    return [*lines, (mark, SMALL, True)] if mark else lines


def _size(kind: str, name: str, mark: str) -> tuple[float, float]:
    lines = label_lines(kind, name, mark)
    width = max(mono_width(text, size) for text, size, _ in lines) + (28 if kind == 'node' else 18)
    return (float(round(width)), 12.0 + 14.0 * len(lines))


class FrameBox(NamedTuple):
    """A frame, with the upper left corner and the size of its box in pixels.

    `kind` is 'root', 'static' or 'dynamic'. `lines` has the rate and the broadcaster. `mark` names a problem, or is ''.
    """

    name: str
    kind: str
    lines: list[str]
    left: float
    top: float
    width: float
    height: float
    mark: str


class TreeScene(NamedTuple):
    """All trees side by side: the frames, the links as pairs (parent, child) of indices into the frames, and the path of each
    link.
    """

    width: float
    height: float
    boxes: list[FrameBox]
    links: list[tuple[int, int]]
    routes: list[list[Point]]
    direction: str

    def caption(self) -> str:
        """Return one line that describes the scene."""
        boxes = self.boxes
        links = [f'{boxes[parent].name} -> {boxes[child].name} ({", ".join(boxes[child].lines)})' for parent, child in self.links]
        roots = [box.name for box in boxes if box.kind == 'root']
        split = f'; {len(roots)} trees that are not connected: {", ".join(roots)}' if len(roots) > 1 else ''
        wrong = [f'; {box.name}: {box.mark}' for box in boxes if box.mark]
        return '; '.join(links) + split + ''.join(wrong)


def tree_scene(recording: Recording) -> TreeScene:
    """Return the tf tree of the whole run.

    :raises ValueError: when no frame was broadcast.
    """
    from edulaunch.engine.recording.frames import frame_links

    found = frame_links(recording)
    if not found:
        raise NothingToDraw('no tf frame was broadcast in this recording: no node published to /tf or /tf_static')
    names = list(dict.fromkeys(name for link in found.values() for name in (*link.parents, link.child)))
    place = {name: number for number, name in enumerate(names)}
    links = [(place[parent], place[link.child]) for link in found.values() for parent in link.parents]
    texts = [_lines(found.get(name)) for name in names]
    sizes = [_tree_size(name, *text) for name, text in zip(names, texts, strict=True)]
    layout = lay_out(sizes, links, 'down')
    if layout.width > WIDEST:
        layout = lay_out(sizes, links, 'right')
    boxes = [
        FrameBox(name, _kind(found.get(name)), lines, *corner, *size, mark)
        for name, (lines, mark), corner, size in zip(names, texts, layout.corners, sizes, strict=True)
    ]
    return TreeScene(layout.width, layout.height, boxes, links, [route.points for route in layout.routes], layout.direction)


def _kind(link: FrameLink | None) -> str:
    return 'root' if link is None else 'static' if link.is_static else 'dynamic'


def _lines(link: FrameLink | None) -> tuple[list[str], str]:
    """Return the lines under a frame's name, and the problem of the frame."""
    if link is None:
        return ['root'], ''
    rate = link.rate_hz
    how = 'static' if link.is_static else 'broadcast once' if rate is None else f'{rate:.1f} Hz'
    mark = (
        'its own parent'
        if link.child in link.parents
        else f'{len(link.parents)} parents'
        if len(link.parents) > 1
        else f'{len(link.broadcasters)} broadcasters'
        if len(link.broadcasters) > 1
        else ''
    )
    return [how, *(f'by {node}' for node in link.broadcasters)], mark


def _tree_size(name: str, lines: list[str], mark: str) -> tuple[float, float]:
    width = max(mono_width(shortened(name)), *(mono_width(shortened(line), SMALL) for line in [*lines, mark]))
    return (float(round(width) + 22), LINE * (len(lines) + 1 + bool(mark)) + 12)

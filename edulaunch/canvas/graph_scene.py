"""Nodes and topics of a recording, laid out in columns from publishers to subscribers, as plain data."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

HIDDEN = ('/rosout', '/parameter_events')


class Box(NamedTuple):
    """A node or a topic at a place: column from the left, row from the top. `mark` says what is wrong with it, or ''."""

    kind: str
    name: str
    column: int
    row: float
    mark: str


class GraphScene(NamedTuple):
    """Boxes, and arrows between their positions in the list."""

    boxes: list[Box]
    arrows: list[tuple[int, int]]

    def caption(self) -> str:
        """One line that says what is to be seen."""
        nodes = [box.name for box in self.boxes if box.kind == 'node']
        marked = [f'{box.name}: {box.mark}' for box in self.boxes if box.mark]
        text = f'{len(nodes)} nodes, {len(self.boxes) - len(nodes)} topics, {len(self.arrows)} connections'
        return text + (f'; {"; ".join(marked)}' if marked else '')


def graph_scene(recording: Recording, unused: bool = False) -> GraphScene:
    """The graph at the end of a run; topics without listeners only if `unused`."""
    edges: list[tuple[tuple[str, str], tuple[str, str]]] = []
    marks: dict[tuple[str, str], str] = {}
    for topic in recording.topics.values():
        if topic.name in HIDDEN or (not topic.subscriptions and not unused):
            continue
        key = ('topic', topic.name)
        edges += [(('node', node), key) for node in topic.publishers] + [(key, ('node', node)) for node in topic.subscriptions]
        if not topic.publishers:
            marks[key] = 'no publisher'
        elif not topic.subscriptions:
            marks[key] = 'no subscriber'
    keys = list(dict.fromkeys([key for edge in edges for key in edge] + [('node', node.name) for node in recording.nodes]))
    columns = _columns(keys, edges)
    boxes = _rows(keys, edges, columns, marks)
    place = {(box.kind, box.name): position for position, box in enumerate(boxes)}
    return GraphScene(boxes, [(place[start], place[end]) for start, end in edges])


def _columns(keys: list[tuple[str, str]], edges: list[tuple[tuple[str, str], tuple[str, str]]]) -> dict[tuple[str, str], int]:
    """The column of each box: the longest way to it; boxes that lie on a loop share their loop's order of discovery."""
    import networkx as nx
    graph = nx.DiGraph()
    graph.add_nodes_from(keys)
    graph.add_edges_from(edges)
    for start, end in _back_edges(keys, graph):
        graph.remove_edge(start, end)
    columns: dict[tuple[str, str], int] = {}
    for key in nx.lexicographical_topological_sort(graph, key=keys.index):
        columns[key] = max((columns[before] + 1 for before in graph.predecessors(key)), default=0 if key[0] == 'node' else 1)
    return columns


def _back_edges(keys: list[tuple[str, str]], graph: object) -> list[tuple[tuple[str, str], tuple[str, str]]]:
    """The edges that close loops, found by walking depth first in the given order."""
    state: dict[tuple[str, str], int] = {}
    back = []
    for root in keys:
        stack = [(root, iter(list(graph.successors(root))))]  # type: ignore[attr-defined]
        if root in state:
            continue
        state[root] = 1
        while stack:
            key, following = stack[-1]
            step = next(following, None)
            if step is None:
                state[key] = 2
                stack.pop()
            elif state.get(step) == 1:
                back.append((key, step))
            elif step not in state:
                state[step] = 1
                stack.append((step, iter(list(graph.successors(step)))))  # type: ignore[attr-defined]
    return back


def _rows(keys: list[tuple[str, str]], edges: list[tuple[tuple[str, str], tuple[str, str]]],
          columns: dict[tuple[str, str], int], marks: dict[tuple[str, str], str]) -> list[Box]:
    """Rows within each column, ordered so that a box stands near what leads to it."""
    row: dict[tuple[str, str], float] = {}
    boxes = []
    for column in range(max(columns.values(), default=0) + 1):
        members = [key for key in keys if columns[key] == column]
        wish = {}
        for key in members:
            before = [row[start] for start, end in edges if end == key and start in row]
            wish[key] = sum(before) / len(before) if before else float(members.index(key))
        members.sort(key=lambda key: (wish[key], keys.index(key)))
        for number, key in enumerate(members):
            row[key] = number - (len(members) - 1) / 2
            boxes.append(Box(*key, column, row[key], marks.get(key, '')))
    return boxes

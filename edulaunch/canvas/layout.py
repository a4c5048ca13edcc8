"""Functions that arrange boxes of given sizes in layers on a sheet, and find paths for arrows between them that cross no box.

Sugiyama's method reverses edges that close a loop, and puts each item on the layer of its longest path. An arrow over
several layers gets a *joint* in each layer that it crosses. Then each box moves to the mean of its neighbours until the
number of crossings stays the same.
"""

from __future__ import annotations

from typing import NamedTuple

Edge = tuple[int, int]
ORDER_SWEEPS = 8
Point = tuple[float, float]
Size = tuple[float, float]
MARGIN, BETWEEN_LAYERS, BETWEEN_BOXES, JOINT, PORT = 12.0, 44.0, 16.0, 10.0, 9.0
SWEEPS = 12
WIDEST = 900.0
"""The width of a notebook's cell in pixels. Layers go from left to right if they fit, and otherwise from top to bottom."""


class Layers(NamedTuple):
    """The items of each layer, in order. Items with numbers from `count` are joints.

    For each edge, `chains` has its items from the first layer to the last, and `turned` states whether its arrow points the
    other way.
    """

    layers: list[list[int]]
    chains: list[list[int]]
    turned: list[bool]


def make_layers(count: int, edges: list[Edge]) -> Layers:
    """Return the layers of the items 0 to count-1. An item without edges is in the first layer.

    :param edges: (from, to) for each arrow. The arrows may form loops; an arrow that closes a loop is reversed.
    """
    back = _back_edges(count, edges)
    forward = [(b, a) if number in back else (a, b) for number, (a, b) in enumerate(edges)]
    rank = _ranks(count, forward)
    layers: list[list[int]] = [[] for _ in range(max(rank, default=0) + 1)]
    for item in range(count):
        layers[rank[item]].append(item)
    chains, joint = [], count
    for a, b in forward:
        chain = [a]
        for layer in range(rank[a] + 1, rank[b]):
            layers[layer].append(joint)
            chain.append(joint)
            joint += 1
        chains.append([*chain, b])
    return Layers(_ordered(layers, chains), chains, [number in back for number in range(len(edges))])


def _back_edges(count: int, edges: list[Edge]) -> set[int]:
    """Return the edges that close a loop. A depth-first search finds them; it begins with the items without incoming edges."""
    following: list[list[tuple[int, int]]] = [[] for _ in range(count)]
    for number, (a, b) in enumerate(edges):
        following[a].append((number, b))
    entered = {b for _, b in edges}
    state = [0] * count
    back: set[int] = set()
    for root in sorted(range(count), key=lambda item: item in entered):
        stack = [] if state[root] else [(root, iter(following[root]))]
        state[root] = state[root] or 1
        while stack:
            item, steps = stack[-1]
            number, step = next(steps, (-1, -1))
            if step < 0:
                state[item] = 2
                stack.pop()
            elif state[step] == 1:
                back.add(number)
            elif state[step] == 0:
                state[step] = 1
                stack.append((step, iter(following[step])))
    return back


def _ranks(count: int, edges: list[Edge]) -> list[int]:
    """Return the layer of each item, which is its longest path. An item without incoming edges is one layer before its
    targets.
    """
    rank = [0] * count
    before: list[list[int]] = [[] for _ in range(count)]
    after: list[list[int]] = [[] for _ in range(count)]
    for a, b in edges:
        before[b].append(a)
        after[a].append(b)
    waiting = [len(sources) for sources in before]
    ready = [item for item in range(count) if not waiting[item]]
    for item in ready:  # the loop itself adds items to this list
        for step in after[item]:
            rank[step] = max(rank[step], rank[item] + 1)
            waiting[step] -= 1
            if not waiting[step]:
                ready.append(step)
    for item in range(count):
        if not before[item] and after[item]:
            rank[item] = min(rank[step] for step in after[item]) - 1
    return rank


def _ordered(layers: list[list[int]], chains: list[list[int]]) -> list[list[int]]:
    """Return the layers, with items in the order that has the fewest crossing arrows."""
    links = [(a, b) for chain in chains for a, b in zip(chain, chain[1:], strict=False)]
    before: dict[int, list[int]] = {}
    after: dict[int, list[int]] = {}
    for a, b in links:
        before.setdefault(b, []).append(a)
        after.setdefault(a, []).append(b)
    best, fewest = layers, crossings(layers, links)
    for sweep in range(ORDER_SWEEPS):
        down = sweep % 2 == 0
        layers = _swept(layers if down else layers[::-1], before if down else after)
        layers = layers if down else layers[::-1]
        number = crossings(layers, links)
        if number < fewest:
            best, fewest = layers, number
    return best


def _swept(layers: list[list[int]], neighbours: dict[int, list[int]]) -> list[list[int]]:
    """Sort each layer by the mean position of its items' neighbours in the previous layer."""
    swept = [layers[0]]
    for layer in layers[1:]:
        place = {item: number for number, item in enumerate(swept[-1])}
        wanted = {}
        for number, item in enumerate(layer):
            places = [place[other] for other in neighbours.get(item, ()) if other in place]
            wanted[item] = sum(places) / len(places) if places else float(number)
        swept.append(sorted(layer, key=wanted.__getitem__))
    return swept


def crossings(layers: list[list[int]], links: list[Edge]) -> int:
    """Return the number of pairs of links that cross between neighbouring layers.

    :param layers: the items of each layer in order.
    :param links: pairs (a, b), where b is in the layer after a.
    """
    place = {item: number for layer in layers for number, item in enumerate(layer)}
    layer_of = {item: number for number, layer in enumerate(layers) for item in layer}
    total = 0
    for number in range(len(layers) - 1):
        ends = sorted((place[a], place[b]) for a, b in links if layer_of[a] == number)
        total += sum(b1 > b2 for position, (_, b1) in enumerate(ends) for _, b2 in ends[position + 1 :])
    return total


class Route(NamedTuple):
    """The path of an arrow: points from its tail to its head.

    The odd-numbered segments (the first, the third and so on) are straight.
    The segments between them are S-curves whose ends follow the direction
    of the layers.
    """

    points: list[Point]


class Layout(NamedTuple):
    """The size of the sheet, the upper left corner of each box, the path of each arrow, and the direction of the layers.

    x points right and y down. The direction is 'right' or 'down'.
    """

    width: float
    height: float
    corners: list[Point]
    routes: list[Route]
    direction: str


def lay_out(sizes: list[Size], edges: list[Edge], direction: str | None = None) -> Layout:
    """Return positions for boxes with the given sizes (width, height), and paths for the arrows between them.

    :param direction: 'right' or 'down'; None means to the right if that fits.
    """
    if direction is not None:
        return _sheet(sizes, edges, direction)
    right = _sheet(sizes, edges, 'right')
    down = right if right.width <= WIDEST else _sheet(sizes, edges, 'down')
    return down if down.width < right.width else right


def _sheet(sizes: list[Size], edges: list[Edge], direction: str) -> Layout:
    """Arrange each connected group separately. The groups follow one another across the direction of the layers."""
    right = direction == 'right'
    corners: list[Point] = [(0.0, 0.0)] * len(sizes)
    routes = [Route([])] * len(edges)
    along, across = 0.0, MARGIN
    for items, numbers in _groups(len(sizes), edges):
        own = {item: position for position, item in enumerate(items)}
        group = _Group(
            [sizes[item] if right else sizes[item][::-1] for item in items],
            [(own[edges[number][0]], own[edges[number][1]]) for number in numbers],
        )
        for item, (a, c) in zip(items, group.corners, strict=True):
            corners[item] = _turned(a + MARGIN, c + across, right)
        for number, points in zip(numbers, group.routes(), strict=True):
            routes[number] = Route([_turned(a + MARGIN, c + across, right) for a, c in points])
        along, across = max(along, group.length + 2 * MARGIN), across + group.breadth + BETWEEN_BOXES
    return Layout(*_turned(along, across - BETWEEN_BOXES + MARGIN, right), corners, routes, direction)


def _turned(along: float, across: float, right: bool) -> Point:
    return (round(along, 2), round(across, 2)) if right else (round(across, 2), round(along, 2))


def _groups(count: int, edges: list[Edge]) -> list[tuple[list[int], list[int]]]:
    """Return the connected groups, largest first: the items of each group and the numbers of its edges."""
    group = list(range(count))
    for a, b in edges:
        low, high = sorted((group[a], group[b]))
        group = [low if name == high else name for name in group]
    found = [
        (
            [item for item in range(count) if group[item] == name],
            [number for number, (a, _) in enumerate(edges) if group[a] == name],
        )
        for name in dict.fromkeys(group)
    ]
    return sorted(found, key=lambda parts: -len(parts[0]))


class _Group:
    """The layout of one connected group. Sizes and corners are (along, across) the direction of the layers."""

    def __init__(self, sizes: list[Size], edges: list[Edge]) -> None:
        self.layers: Layers = make_layers(len(sizes), edges)
        joints = sum(len(chain) - 2 for chain in self.layers.chains)
        self.sizes = [*sizes, *[(0.0, JOINT)] * joints]
        self.count = len(sizes)
        self.centres = _centres(self.layers, [across for _, across in self.sizes], self.count)
        top = min(centre - across / 2 for centre, (_, across) in zip(self.centres, self.sizes, strict=True))
        self.centres = [centre - top for centre in self.centres]
        self.breadth = max(centre + across / 2 for centre, (_, across) in zip(self.centres, self.sizes, strict=True))
        self.starts, self.depths = self._depths()
        self.layer_of = {item: number for number, layer in enumerate(self.layers.layers) for item in layer}
        self.length = self.starts[-1] + self.depths[-1]

    def _depths(self) -> tuple[list[float], list[float]]:
        """Return the start and the depth of each layer."""
        depths = [max((self.sizes[item][0] for item in layer), default=0.0) for layer in self.layers.layers]
        starts = [0.0]
        for depth in depths[:-1]:
            starts.append(starts[-1] + depth + BETWEEN_LAYERS)
        return starts, depths

    @property
    def corners(self) -> list[Point]:
        """Return the corners of the boxes. Each box is in the middle of its layer's depth."""
        found = []
        for item in range(self.count):
            (along, across), layer = self.sizes[item], self.layer_of[item]
            found.append((self.starts[layer] + (self.depths[layer] - along) / 2, self.centres[item] - across / 2))
        return found

    def routes(self) -> list[list[Point]]:
        """Return the path of each arrow, beginning at its tail."""
        out, into = self._ports(0), self._ports(-1)
        found = []
        for number, (chain, turned) in enumerate(zip(self.layers.chains, self.layers.turned, strict=True)):
            points: list[Point] = []
            for item in chain:
                layer = self.layer_of[item]
                begin, end = self.starts[layer], self.starts[layer] + self.depths[layer]
                if item == chain[0]:
                    points += [((begin + end + self.sizes[item][0]) / 2, out[number]), (end, out[number])]
                elif item == chain[-1]:
                    points += [(begin, into[number]), ((begin + end - self.sizes[item][0]) / 2, into[number])]
                else:
                    points += [(begin, self.centres[item]), (end, self.centres[item])]
            found.append(points[::-1] if turned else points)
        return found

    def _ports(self, side: int) -> list[float]:
        """Return where each arrow meets its box, spread to avoid crossings. Side 0 has the outgoing arrows, side -1 the incoming
        arrows.
        """
        chains = self.layers.chains
        ports = [0.0] * len(chains)
        for item in range(self.count):
            mine = [number for number, chain in enumerate(chains) if chain[side] == item]
            mine.sort(key=lambda number: self.centres[chains[number][1 if side == 0 else -2]])
            step = min(PORT, (self.sizes[item][1] - 14) / max(1, len(mine) - 1)) if len(mine) > 1 else 0.0
            for position, number in enumerate(mine):
                ports[number] = self.centres[item] + (position - (len(mine) - 1) / 2) * step
        return ports


def mean(numbers: list[float]) -> float:
    """Return the mean of a non-empty sequence of numbers."""
    return sum(numbers) / len(numbers)


def _centres(layers: Layers, breadths: list[float], count: int) -> list[float]:
    """Return the centre of each item across the layers, near the mean of its neighbours, and far enough from the items beside
    it.
    """
    near: list[list[int]] = [[] for _ in breadths]
    for chain in layers.chains:
        for a, b in zip(chain, chain[1:], strict=False):
            near[a].append(b)
            near[b].append(a)
    centres = [0.0] * len(breadths)
    for layer in layers.layers:
        for item, centre in zip(layer, _spread_out([0.0] * len(layer), layer, breadths, count), strict=True):
            centres[item] = centre
    for sweep in range(SWEEPS):
        for layer in layers.layers if sweep % 2 == 0 else layers.layers[::-1]:
            wanted_places = [mean([centres[other] for other in near[item]] or [centres[item]]) for item in layer]
            for item, centre in zip(layer, _spread_out(wanted_places, layer, breadths, count), strict=True):
                centres[item] = centre
    return centres


def _spread_out(wanted_places: list[float], layer: list[int], breadths: list[float], count: int) -> list[float]:
    """Return the positions nearest to the desired positions (least squares) that keep the order and the minimum distances.

    Without the distances, the task is to find increasing numbers: neighbours in the wrong order get their common mean.
    """
    offsets = [0.0]
    for a, b in zip(layer, layer[1:], strict=False):
        gap = BETWEEN_BOXES if a < count and b < count else BETWEEN_BOXES / 2
        offsets.append(offsets[-1] + (breadths[a] + breadths[b]) / 2 + gap)
    blocks: list[tuple[float, int]] = []
    for wanted, offset in zip(wanted_places, offsets, strict=True):
        total, size = wanted - offset, 1
        while blocks and blocks[-1][0] / blocks[-1][1] >= total / size:
            total, size = total + blocks[-1][0], size + blocks[-1][1]
            blocks.pop()
        blocks.append((total, size))
    means = [total / size for total, size in blocks for _ in range(size)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=True)]

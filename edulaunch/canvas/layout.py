"""Boxes of given sizes put on a sheet in layers, and ways for the arrows between them that cross no box."""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.canvas.layering import Edge, Layers, make_layers

Point = tuple[float, float]
Size = tuple[float, float]
MARGIN, BETWEEN_LAYERS, BETWEEN_BOXES, JOINT, PORT = 12.0, 44.0, 16.0, 10.0, 9.0
SWEEPS = 12
WIDEST = 900.0
"""Layers go from left to right while that needs no more pixels than a notebook's cell has, else from top to bottom."""


class Route(NamedTuple):
    """The way of an arrow: points from its tail to its head. Every second stretch, beginning with the first, is straight; the
    others are S-curves whose ends lie along the direction of the layers.
    """

    points: list[Point]


class Layout(NamedTuple):
    """The sheet's size, the upper left corner of each box, the way of each arrow (x to the right, y down), and the direction of
    the layers: 'right' or 'down'.
    """

    width: float
    height: float
    corners: list[Point]
    routes: list[Route]
    direction: str


def lay_out(sizes: list[Size], edges: list[Edge], direction: str | None = None) -> Layout:
    """Places for boxes with these (width, height) and arrows between them.

    :param direction: 'right' or 'down'; default: to the right if that is narrow enough.
    """
    if direction is not None:
        return _sheet(sizes, edges, direction)
    right = _sheet(sizes, edges, 'right')
    down = right if right.width <= WIDEST else _sheet(sizes, edges, 'down')
    return down if down.width < right.width else right


def _sheet(sizes: list[Size], edges: list[Edge], direction: str) -> Layout:
    """Each connected group is laid out by itself; groups follow one another across the layers."""
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
    """Connected items and the numbers of their edges, largest groups first."""
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
    """One connected group. Sizes and corners are (along, across) the direction of the layers."""

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
        """Where each layer begins, and how deep it is."""
        depths = [max((self.sizes[item][0] for item in layer), default=0.0) for layer in self.layers.layers]
        starts = [0.0]
        for depth in depths[:-1]:
            starts.append(starts[-1] + depth + BETWEEN_LAYERS)
        return starts, depths

    @property
    def corners(self) -> list[Point]:
        """Of the boxes, each in the middle of its layer's depth."""
        found = []
        for item in range(self.count):
            (along, across), layer = self.sizes[item], self.layer_of[item]
            found.append((self.starts[layer] + (self.depths[layer] - along) / 2, self.centres[item] - across / 2))
        return found

    def routes(self) -> list[list[Point]]:
        """The way of each arrow, tail first."""
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
        """Where each arrow meets its box: on side 0 those that leave, on side -1 those that come; spread, so as not to cross."""
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
    """Of at least one number."""
    return sum(numbers) / len(numbers)


def _centres(layers: Layers, breadths: list[float], count: int) -> list[float]:
    """The middle of each item across the layers: near its neighbours' mean, at a distance from those beside it."""
    near: list[list[int]] = [[] for _ in breadths]
    for chain in layers.chains:
        for a, b in zip(chain, chain[1:], strict=False):
            near[a].append(b)
            near[b].append(a)
    centres = [0.0] * len(breadths)
    for layer in layers.layers:
        for item, centre in zip(layer, _apart([0.0] * len(layer), layer, breadths, count), strict=True):
            centres[item] = centre
    for sweep in range(SWEEPS):
        for layer in layers.layers if sweep % 2 == 0 else layers.layers[::-1]:
            wishes = [mean([centres[other] for other in near[item]] or [centres[item]]) for item in layer]
            for item, centre in zip(layer, _apart(wishes, layer, breadths, count), strict=True):
                centres[item] = centre
    return centres


def _apart(wishes: list[float], layer: list[int], breadths: list[float], count: int) -> list[float]:
    """The places nearest to the wishes (least squares) that keep the order and the distances.

    Taking the distances off makes it a question of rising numbers: neighbours that stand in each other's way share their mean.
    """
    offsets = [0.0]
    for a, b in zip(layer, layer[1:], strict=False):
        gap = BETWEEN_BOXES if a < count and b < count else BETWEEN_BOXES / 2
        offsets.append(offsets[-1] + (breadths[a] + breadths[b]) / 2 + gap)
    blocks: list[tuple[float, int]] = []
    for wish, offset in zip(wishes, offsets, strict=True):
        total, size = wish - offset, 1
        while blocks and blocks[-1][0] / blocks[-1][1] >= total / size:
            total, size = total + blocks[-1][0], size + blocks[-1][1]
            blocks.pop()
        blocks.append((total, size))
    means = [total / size for total, size in blocks for _ in range(size)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=True)]

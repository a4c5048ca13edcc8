"""Boxes in layers from first to last, arrows between them: which layer each box belongs to, and in which order.

After Sugiyama: loops are opened, layers are given by the longest way, arrows over several layers get a *joint* in each layer
between, and the order in each layer is improved by placing every box at the mean of its neighbours until arrows cross no less.
"""

from __future__ import annotations

from typing import NamedTuple

Edge = tuple[int, int]
SWEEPS = 8


class Layers(NamedTuple):
    """Items by layer, in order; numbers from `count` on are joints. For each edge its chain of items from first layer to last,
    and whether the arrow points the other way.
    """

    layers: list[list[int]]
    chains: list[list[int]]
    turned: list[bool]


def make_layers(count: int, edges: list[Edge]) -> Layers:
    """Layers for items 0 to count-1."""
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
    """The edges that close a loop, found by walking depth first; items that nothing leads to are walked from first."""
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
    """The layer of each item: the longest way to it; what nothing leads to stands right before what it leads to."""
    rank = [0] * count
    before: list[list[int]] = [[] for _ in range(count)]
    after: list[list[int]] = [[] for _ in range(count)]
    for a, b in edges:
        before[b].append(a)
        after[a].append(b)
    waiting = [len(sources) for sources in before]
    ready = [item for item in range(count) if not waiting[item]]
    for item in ready:  # grows while it is walked
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
    """The layers with the order of their items that lets the fewest arrows cross."""
    links = [(a, b) for chain in chains for a, b in zip(chain, chain[1:], strict=False)]
    before: dict[int, list[int]] = {}
    after: dict[int, list[int]] = {}
    for a, b in links:
        before.setdefault(b, []).append(a)
        after.setdefault(a, []).append(b)
    best, fewest = layers, crossings(layers, links)
    for sweep in range(SWEEPS):
        down = sweep % 2 == 0
        layers = _swept(layers if down else layers[::-1], before if down else after)
        layers = layers if down else layers[::-1]
        number = crossings(layers, links)
        if number < fewest:
            best, fewest = layers, number
    return best


def _swept(layers: list[list[int]], neighbours: dict[int, list[int]]) -> list[list[int]]:
    """Each layer sorted by the mean place of its items' neighbours in the layer before it."""
    swept = [layers[0]]
    for layer in layers[1:]:
        place = {item: number for number, item in enumerate(swept[-1])}
        wish = {}
        for number, item in enumerate(layer):
            places = [place[other] for other in neighbours.get(item, ()) if other in place]
            wish[item] = sum(places) / len(places) if places else float(number)
        swept.append(sorted(layer, key=wish.__getitem__))
    return swept


def crossings(layers: list[list[int]], links: list[Edge]) -> int:
    """How many pairs of links between neighbouring layers cross."""
    place = {item: number for layer in layers for number, item in enumerate(layer)}
    layer_of = {item: number for number, layer in enumerate(layers) for item in layer}
    total = 0
    for number in range(len(layers) - 1):
        ends = sorted((place[a], place[b]) for a, b in links if layer_of[a] == number)
        total += sum(b1 > b2 for position, (_, b1) in enumerate(ends) for _, b2 in ends[position + 1 :])
    return total

"""Two peers of an agenda do what one agenda does, in the same order."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable
from typing import NamedTuple

from hypothesis import given, settings
from hypothesis import strategies as st

from edulaunch.engine.sim.simulation import EPOCH_NS, Simulation
from edulaunch.runtime.link.clock import PeerSimulation
from edulaunch.runtime.link.codec import FrameKind, dump, load
from edulaunch.runtime.link.peer import Gone, Peer
from tests.house import EXAMPLES

END_NS = EPOCH_NS + 8


class Item(NamedTuple):
    """What runs: in which peer, how much later than it was asked for, and what it asks for itself."""

    is_confined: bool
    delay_ns: int
    priority: int
    then: tuple[Item, ...] = ()


def made(of: tuple[bool, int, int, list[Item]]) -> Item:
    return Item(of[0], of[1], of[2], tuple(of[3]))


def asked_for(inner: st.SearchStrategy[list[Item]]) -> st.SearchStrategy[Item]:
    return st.tuples(st.booleans(), st.integers(0, 3), st.sampled_from([0, 0, 0, 1, -1]), inner).map(made)


items = st.recursive(asked_for(st.just([])), lambda inner: asked_for(st.lists(inner, max_size=4)), max_leaves=25)


def at_this_instant_elsewhere(item: Item) -> bool:
    """Whether it jumps the other peer's queue: what a frame makes the other peer do never does."""
    return any(one.priority < 0 and not one.delay_ns for one in walk(item))


def walk(item: Item) -> list[Item]:
    return [item, *(each for child in item.then for each in walk(child))]


def in_one(item: Item) -> list[tuple[int, Item]]:
    sim, log = Simulation(), []

    def ask(one: Item) -> None:
        sim.schedule(sim.now_ns + one.delay_ns, lambda: run(one), one.priority)

    def run(one: Item) -> None:
        log.append((sim.now_ns, one))
        for child in one.then:
            ask(child)

    ask(item)
    sim.run(END_NS)
    return log


def in_two(item: Item) -> list[tuple[int, Item]]:
    ends = socket.socketpair()
    peers = [Peer(PeerSimulation(), end, trusts=is_confined) for end, is_confined in zip(ends, (False, True), strict=True)]
    log: list[tuple[int, Item]] = []
    everything = walk(item)

    def asker(here: int) -> Callable[[Item], None]:
        peer = peers[here]

        def ask(one: Item) -> None:
            if one.is_confined == bool(here):
                peer.sim.schedule(peer.sim.now_ns + one.delay_ns, lambda: run(one), one.priority)
            else:
                peer.tell(FrameKind.NODE, dump(next(number for number, each in enumerate(everything) if each is one)))

        def run(one: Item) -> None:
            log.append((peer.sim.now_ns, one))
            for child in one.then:
                ask(child)

        peer.handlers[FrameKind.NODE] = lambda payload: ask(everything[load(bytes(payload))])
        return ask

    near, _ = asker(0), asker(1)

    def be_confined() -> None:
        peers[1].sim.other = (0, 0, 0, 0)
        try:
            peers[1].sim.run(None)
        except Gone:
            return
        finally:
            ends[1].close()

    confined = threading.Thread(target=be_confined)
    confined.start()
    try:
        peers[0].await_token(EPOCH_NS)
        near(item)
        peers[0].sim.run(END_NS)
    finally:
        ends[0].close()
        confined.join(5.0)
    return log


@settings(max_examples=3 * EXAMPLES // 2)
@given(items.filter(lambda item: not at_this_instant_elsewhere(item)))
def test_two_peers_do_what_one_agenda_does(item: Item) -> None:
    assert in_two(item) == in_one(item)

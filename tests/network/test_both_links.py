"""Two machines at once on one network, one on the default link and one on the full link, and a second one on the full link."""

from __future__ import annotations

import select
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from edulaunch.native import environment
from edulaunch.network.link import Settings
from edulaunch.network.rclpy_link import RclpyLink
from tests.network.places import Place
from tests.network.wires import LIMIT_S

pytestmark = pytest.mark.real


class Places:
    """Machines of all links on one domain, and time that passes for them."""

    def __init__(self, domain: int) -> None:
        self.settings = Settings(domain)
        self.made: list[Place] = []

    def add(self, link: Any, name: str, **options: Any) -> Place:
        self.made.append(Place(link, self.settings, name, wall_ns=time.time_ns, **options))
        self.made[-1].time.is_wall = True
        return self.made[-1]

    def until(self, condition: Callable[[], object], each: Callable[[], object] = lambda: None) -> None:
        end_s = time.monotonic() + LIMIT_S
        while not condition():
            assert time.monotonic() < end_s, 'it never came'
            select.select([place.link for place in self.made], [], [], 0.01)
            for place in self.made:
                place.time.advance()
                place.turn()
            each()


@pytest.fixture
def places(domain: int) -> Iterator[Places]:
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    made = Places(domain)
    yield made
    for place in made.made:
        place.close()


def default_link() -> Any:
    from edulaunch.network.dds.link import CycloneLink

    return CycloneLink()


def seen(place: Place) -> list[tuple[str, bool]]:
    """Who is out there, and who of them is known to be simulated."""
    return sorted((node.name, node.is_simulated) for node in place.link.graph().nodes)


def test_machines_on_both_links_know_each_other_and_hear_each_other_once(places: Places) -> None:
    """No echo of oneself, none through the others, and what a link has for itself none of them shows."""
    links = {'plain': default_link(), 'full': RclpyLink(), 'other': RclpyLink()}
    mouths = {name: places.add(link, name).publisher('/chatter') for name, link in links.items()}
    for place in places.made:
        place.subscription('/chatter')
    places.until(lambda: all(mouth.subscription_count == 3 for mouth in mouths.values()))
    for name, place in zip(links, places.made, strict=True):
        others = sorted((each, True) for each in links if each != name)
        places.until(lambda place=place, others=others: seen(place) == others)
    numbers = iter(range(10_000))

    def talk() -> None:
        number = next(numbers)
        for name, mouth in mouths.items():
            mouth.publish((f'{name} {number}',))

    def heard(place: Place) -> list[str]:
        return [text for (text,) in place.heard]

    places.until(lambda: all({text.split()[0] for text in heard(place)} == set(links) for place in places.made), talk)
    for name, mouth in mouths.items():
        mouth.publish((f'{name} end',))
    places.until(lambda: all({f'{name} end' for name in links} <= set(heard(place)) for place in places.made))
    for place in places.made:
        assert len(place.heard) == len(set(place.heard)), 'something was heard twice'
        assert sorted(place.nodes()) == ['/full', '/other', '/plain'] and not place.said


def test_a_machine_of_which_no_topic_crosses_is_known_and_two_nodes_of_one_name_are_told(places: Places) -> None:
    plain = places.add(default_link(), 'turtle', chosen=lambda name: name == '/reset')
    full = places.add(RclpyLink(), 'turtle', chosen=lambda name: False)
    plain.graph.add_node(plain.node.process, 'quiet', '/')
    places.until(lambda: seen(plain) == [('turtle', True)] and seen(full) == [('quiet', True), ('turtle', True)])
    places.until(lambda: plain.said and full.said)
    told = 'there are two nodes called /turtle: one of this machine, and one of another machine'
    assert [text.split('\n')[0] for text in (*plain.said, *full.said)] == [told, told]

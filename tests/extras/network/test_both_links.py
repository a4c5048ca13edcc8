"""Machines on both links at once on one network, and what either link has to endure."""

from __future__ import annotations

import select
import socket
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from random import Random
from typing import Any

import pytest

from edulaunch.extras.native import environment
from edulaunch.extras.network.crossing import Crossing
from edulaunch.extras.network.network_link import Settings
from edulaunch.extras.network.rclpy_link import RclpyLink
from tests.extras.network.places import Place
from tests.extras.network.wires import LIMIT_S

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
    from edulaunch.extras.network.dds.link import CycloneLink

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
    places.until(lambda: all(sorted(place.nodes()) == ['/full', '/other', '/plain'] for place in places.made))
    for place in places.made:
        assert len(place.heard) == len(set(place.heard)), 'something was heard twice'
        assert not place.said


def test_a_machine_of_which_no_topic_crosses_is_known_and_two_nodes_of_one_name_are_told(places: Places) -> None:
    plain = places.add(default_link(), 'turtle', crossing=Crossing(['/reset']))
    full = places.add(RclpyLink(), 'turtle', crossing=Crossing(deny=['/']))
    plain.graph.add_node(plain.node.process, 'quiet', '/')
    places.until(lambda: seen(plain) == [('turtle', True)] and seen(full) == [('quiet', True), ('turtle', True)])
    places.until(lambda: plain.said and full.said)
    told = 'two nodes have the name /turtle: one of this machine, and one of another machine'
    assert [text.split('\n')[0] for text in (*plain.said, *full.said)] == [told, told]


def hostile_packets() -> Iterator[bytes]:
    """What looks like RTPS and is none, and what does not even look so: lengths too large, cut off, noise."""
    random = Random(7)
    for number in range(1500):
        kind = random.choice((0x01, 0x06, 0x07, 0x08, 0x09, 0x0E, 0x12, 0x13, 0x15, 0x16, 0x80, 0xFF))
        length = random.choice((0, 1, 4, 20, 24, 0xFFFF, random.randrange(0x10000)))
        body = random.randbytes(random.choice((0, 3, 16, 24, 60, 400)))
        header = b'RTPS\x02\x03' + random.choice((b'\x01\x0f', b'\x01\x10')) + random.randbytes(12)
        submessage = bytes((kind, random.randrange(256))) + length.to_bytes(2, 'little')
        yield (header + submessage + body, header[: random.randrange(20)], random.randbytes(random.randrange(1400)))[number % 3]


@pytest.mark.parametrize('make', [default_link, RclpyLink])
def test_packets_that_are_none_do_no_harm(places: Places, make: Callable[[], Any]) -> None:
    here, there = places.add(make(), 'here'), places.add(make(), 'there')
    mouth = here.publisher('/chatter')
    there.subscription('/chatter')
    places.until(lambda: there.heard, lambda: mouth.publish(('before',)))
    ports = [7400 + 250 * places.settings.domain + offset for offset in (0, 1, *range(10, 18))]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as enemy:
        for packet in hostile_packets():
            for port in ports:
                with suppress(ConnectionRefusedError):
                    enemy.sendto(packet, ('127.0.0.1', port))
    places.until(lambda: there.heard[-1] == ('after',), lambda: mouth.publish(('after',)))
    late = places.add(make(), 'late')
    late.subscription('/chatter')
    places.until(lambda: late.heard, lambda: mouth.publish(('late',)))
    places.until(lambda: sorted(late.nodes()) == ['/here', '/late', '/there'])
    late_ones = 'its clock or the network is slow'  # on a busy computer messages are
    assert not [text for place in places.made for text in place.said if late_ones not in text]


@pytest.mark.parametrize('make', [default_link, RclpyLink])
def test_another_type_on_a_topic_and_hundreds_of_endpoints_do_no_harm(places: Places, make: Callable[[], Any]) -> None:
    here, there = places.add(make(), 'here'), places.add(make(), 'there')
    here.subscription('/chatter')
    wrong = there.publisher('/chatter', 'geometry_msgs/msg/Twist')
    many = [there.publisher(f'/many/topic{number}') for number in range(300)]
    right = places.add(make(), 'third').publisher('/chatter')
    places.until(lambda: sum(topic.startswith('/many/') for topic in here.graph.publishers) == 300)
    places.until(lambda: here.heard, lambda: (wrong.publish((0.0,) * 6), right.publish(('right',))))
    assert set(here.heard) == {('right',)}
    for publisher in many:
        publisher.destroy()
    places.until(lambda: not any(here.graph.publishers.get(f'/many/topic{number}') for number in range(300)))

"""Two computers on one, run by `unshare -rn`: two namespaces of the network with a cable between them. Prints a line of JSON.

The arguments: the link, a discovery range, how many of 1000 packets are lost, and how long each takes in ms.
"""

from __future__ import annotations

import json
import os
import select
import socket
import subprocess
import sys
import time
from typing import Any

from edulaunch.engine.graph.qos import BEST_EFFORT, QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import (
    CLIENT,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Interface,
    Link,
    Message,
    Request,
    Response,
)
from edulaunch.extras.network.settings import settings_of
from edulaunch.ros.serialization.cdr import deserialize, encode, serialize
from tests.extras.network.cable import Cable, card
from tests.extras.network.places import STRING, TRIGGER, cls_of, text, words_in

ADDRESSES = ('10.99.0.1', '10.99.0.2')
COUNT = 500
TF = 'tf2_msgs/msg/TFMessage'
LIMIT_S = 120.0


def joined(link_name: str, wide: str, peer: str) -> Link:
    """On the network."""
    link = make_link(link_name)
    link.open(settings_of({'ROS_AUTOMATIC_DISCOVERY_RANGE': wide, 'ROS_STATIC_PEERS': peer if wide == 'LOCALHOST' else ''}))
    return link


def interface(name: str) -> Interface:
    return Interface(name, underlay_registry())


def transform(stamp_ns: int) -> bytes:
    """Where the talker is at a time."""
    message = cls_of('geometry_msgs/msg/TransformStamped')(child_frame_id='talker')
    message.header.frame_id = 'world'
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp_ns, 10**9)
    return serialize(cls_of(TF)(transforms=[message]))


def talk(link: Link) -> None:
    """The one computer: talks, tells where it is, and serves."""
    node = link.add_node('/', 'talker')
    mouths = {
        name: link.add(node, PUBLISHER, f'/{name}', interface(STRING), QoS(depth=COUNT, reliability=name))
        for name in ('reliable', BEST_EFFORT)
    }
    tf = link.add(node, PUBLISHER, '/tf', interface(TF), QoS(depth=100))
    link.add(node, SERVICE, '/done', interface(TRIGGER), QoS())
    sent, done_s = 0, None
    while done_s is None or time.monotonic() < done_s:
        link.flush()
        select.select([link], [], [], 0.002)
        for event in link.take():
            if isinstance(event, Request):
                link.reply(event.handle, event.who, encode(cls_of(TRIGGER).Response, (True, str(sent))))
                done_s = done_s or time.monotonic() + 3.0
        ears = {end.name for end in link.graph().endpoints if end.kind == SUBSCRIPTION}
        if sent < COUNT and ears >= {'/reliable', f'/{BEST_EFFORT}', '/tf'}:
            sent += 1
            for mouth in mouths.values():
                link.publish(mouth, text(str(sent)))
            link.publish(tf, transform(time.time_ns()))


def hear(link: Link) -> dict[str, Any]:
    """The other computer: listens, and asks at the end."""
    node = link.add_node('/', 'listener')
    names = {
        link.add(node, SUBSCRIPTION, f'/{name}', interface(STRING), QoS(depth=COUNT, reliability=name)): name
        for name in ('reliable', BEST_EFFORT)
    }
    tf = link.add(node, SUBSCRIPTION, '/tf', interface(TF), QoS(depth=100))
    client = link.add(node, CLIENT, '/done', interface(TRIGGER), QoS())
    heard: dict[str, list[str]] = {name: [] for name in names.values()}
    stamps_ns, late_ns = [], []
    end_s, asked_s, number, answered = time.monotonic() + LIMIT_S, 0.0, 0, False
    while not answered and time.monotonic() < end_s:
        link.flush()
        select.select([link], [], [], 0.05)
        for event in link.take():
            if isinstance(event, Message) and event.handle == tf:
                stamp = deserialize(event.cdr, cls_of(TF)).transforms[0].header.stamp
                stamps_ns.append(stamp.sec * 10**9 + stamp.nanosec)
                late_ns.append(time.time_ns() - stamps_ns[-1])
            elif isinstance(event, Message):
                heard[names[event.handle]].append(words_in(event.cdr))
            answered |= isinstance(event, Response)
        is_served = any(end.kind == SERVICE and end.name == '/done' for end in link.graph().endpoints)
        if heard['reliable'][-1:] == [str(COUNT)] and is_served and time.monotonic() > asked_s + 0.5:
            asked_s, number = time.monotonic(), number + 1
            link.request(client, number, encode(cls_of(TRIGGER).Request, ()))
    first = int(heard['reliable'][0]) if heard['reliable'] else 0
    return {
        'reliable': heard['reliable'] == [str(number) for number in range(first, COUNT + 1)],
        'first': first,
        'best_effort': len(heard[BEST_EFFORT]),
        'answered': answered,
        'nodes': [(node.name, node.is_simulated) for node in link.graph().nodes],
        'tf': len(stamps_ns),
        'tf_in_order': stamps_ns == sorted(stamps_ns),
        'tf_late_ms': [round(late / 1e6, 1) for late in (min(late_ns, default=0), max(late_ns, default=0))],
    }


def far(link_name: str, wide: str) -> None:
    """What the other program does: hands over its end of the cable, and talks when that is plugged in."""
    with socket.socket(fileno=0) as near:
        socket.send_fds(near, [b'.'], [card('far', ADDRESSES[1])])
        near.recv(1)
        talk(joined(link_name, wide, ADDRESSES[0]))


def main(link_name: str, wide: str, lost: int, delay_ms: int) -> None:
    if os.environ.get('FAR'):
        far(link_name, wide)
        return
    ours, theirs = socket.socketpair()
    words = ['unshare', '-n', sys.executable, '-m', 'tests.extras.network.two_computers', *sys.argv[1:]]
    other = subprocess.Popen(words, env={**os.environ, 'FAR': '1'}, stdin=theirs)
    theirs.close()
    try:
        _, [far_end], _, _ = socket.recv_fds(ours, 1, 1)
        cable = Cable((card('near', ADDRESSES[0]), far_end), lost, delay_ms)
        cable.start()
        ours.send(b'.')
        link = joined(link_name, wide, ADDRESSES[1])
        found = hear(link)
        link.close()
        print(json.dumps({**found, 'dropped': cable.dropped}))
    finally:
        other.kill()
        other.wait()


if __name__ == '__main__':
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))

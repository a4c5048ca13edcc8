"""Two computers on one, run by `unshare -rn`: two namespaces of the network with a cable between them. Prints a line of JSON.

The arguments: a discovery range, how many of 1000 packets are lost, and how long each takes in ms (that wants a kernel with netem).
"""

from __future__ import annotations

import json
import os
import select
import subprocess
import sys
import time
from typing import Any

import edulaunch.network.dds.domain as domain
from edulaunch.graph.qos import BEST_EFFORT, QoS
from edulaunch.interfaces.cdr import encode
from edulaunch.interfaces.registry import underlay_registry
from edulaunch.network.dds.link import CycloneLink
from edulaunch.network.link import CLIENT, PUBLISHER, SERVICE, SUBSCRIPTION, Interface, Message, Request, Response
from edulaunch.network.settings import settings_of
from tests.network.places import STRING, TRIGGER, cls_of, text, words_in

ADDRESSES = ('10.99.0.1', '10.99.0.2')
COUNT = 500
NETEM = ('tc', 'qdisc', 'add')
LIMIT_S = 120.0


def ip(*words: str) -> None:
    subprocess.run(['ip', *words], check=True)


def plug(name: str, address: str) -> None:
    """Switch the end of the cable on."""
    ip('link', 'set', 'lo', 'up')
    ip('address', 'add', f'{address}/24', 'dev', name)
    ip('link', 'set', name, 'up')
    ip('route', 'add', 'default', 'dev', name)


def joined(wide: str, lost: int, peer: str) -> CycloneLink:
    """On the network, which loses packets."""
    usual = domain.configuration
    loss = f'<Internal><Test><XmitLossiness>{lost}</XmitLossiness></Test></Internal></Domain>'
    domain.configuration = lambda settings: usual(settings).replace('</Domain>', loss)
    env = {'ROS_AUTOMATIC_DISCOVERY_RANGE': wide, 'ROS_STATIC_PEERS': peer if wide == 'LOCALHOST' else ''}
    link = CycloneLink()
    link.open(settings_of(env))
    return link


def talk(link: CycloneLink) -> None:
    """The one computer: talks, and serves."""
    node = link.add_node('/', 'talker')
    interface = Interface(STRING, underlay_registry())
    mouths = {
        name: link.add(node, PUBLISHER, f'/{name}', interface, QoS(depth=COUNT, reliability=name))
        for name in ('reliable', BEST_EFFORT)
    }
    link.add(node, SERVICE, '/done', Interface(TRIGGER, underlay_registry()), QoS())
    ears: set[str] = set()
    sent, done_s = 0, None
    while done_s is None or time.monotonic() < done_s:
        link.flush()
        select.select([link], [], [], 0.002)
        for event in link.take():
            if isinstance(event, Request):
                link.reply(event.handle, event.who, encode(cls_of(TRIGGER).Response, (True, str(sent))))
                done_s = done_s or time.monotonic() + 3.0
        ears = {end.name for end in link.graph().endpoints if end.kind == SUBSCRIPTION}
        if sent < COUNT and len(ears) == 2:
            sent += 1
            for mouth in mouths.values():
                link.publish(mouth, text(str(sent)))


def hear(link: CycloneLink) -> dict[str, Any]:
    """The other computer: listens, and asks at the end."""
    node = link.add_node('/', 'listener')
    interface = Interface(STRING, underlay_registry())
    names = {
        link.add(node, SUBSCRIPTION, f'/{name}', interface, QoS(depth=COUNT, reliability=name)): name
        for name in ('reliable', BEST_EFFORT)
    }
    client = link.add(node, CLIENT, '/done', Interface(TRIGGER, underlay_registry()), QoS())
    heard: dict[str, list[str]] = {name: [] for name in names.values()}
    end_s, asked_s, number, answered = time.monotonic() + LIMIT_S, 0.0, 0, False
    while not answered and time.monotonic() < end_s:
        link.flush()
        select.select([link], [], [], 0.05)
        for event in link.take():
            if isinstance(event, Message):
                heard[names[event.handle]].append(words_in(event.cdr))
            answered |= isinstance(event, Response)
        is_served = any(end.kind == SERVICE for end in link.graph().endpoints)
        if heard['reliable'][-1:] == [str(COUNT)] and is_served and time.monotonic() > asked_s + 0.5:
            asked_s, number = time.monotonic(), number + 1
            link.request(client, number, encode(cls_of(TRIGGER).Request, ()))
    first = int(heard['reliable'][0]) if heard['reliable'] else 0
    return {
        'reliable': heard['reliable'] == [str(number) for number in range(first, COUNT + 1)],
        'first': first,
        'best_effort': len(heard[BEST_EFFORT]),
        'answered': answered,
        'nodes': [node.name for node in link.graph().nodes],
    }


def main(wide: str, lost: int, delay_ms: int) -> None:
    if os.environ.get('FAR'):
        sys.stdin.readline()
        plug('far', ADDRESSES[1])
        talk(joined(wide, lost, ADDRESSES[0]))
        return
    command = ['unshare', '-n', sys.executable, '-m', 'tests.network.two_computers', wide, str(lost), str(delay_ms)]
    far = subprocess.Popen(command, env={**os.environ, 'FAR': '1'}, stdin=subprocess.PIPE, text=True)
    try:
        while os.readlink(f'/proc/{far.pid}/ns/net') == os.readlink('/proc/self/ns/net'):
            time.sleep(0.01)
        ip('link', 'add', 'near', 'type', 'veth', 'peer', 'name', 'far', 'netns', str(far.pid))
        plug('near', ADDRESSES[0])
        if delay_ms:
            subprocess.run([*NETEM, 'dev', 'near', 'root', 'netem', 'delay', f'{delay_ms}ms'], check=True)
        assert far.stdin is not None
        far.stdin.write('go\n')
        far.stdin.flush()
        print(json.dumps(hear(joined(wide, lost, ADDRESSES[1]))))
    finally:
        far.kill()
        far.wait()


if __name__ == '__main__':
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))

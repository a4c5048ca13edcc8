"""A stranger on another computer, run by `unshare -rnm`: he names us in ROS_STATIC_PEERS, listens to /chatter and speaks on it. Prints a
line of JSON: what he saw of us, what we heard of him, and at how many of our ports his packets arrived.

The arguments: who we are (cyclonedds, rclpy, real or compare), and a discovery range.
"""

from __future__ import annotations

import fcntl
import json
import os
import select
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from edulaunch.engine.graph.qos import QoS
from edulaunch.extras.comparing.for_real import DOMAINS
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import PUBLISHER, SUBSCRIPTION, Link, Message
from edulaunch.extras.network.settings import settings_of
from tests.extras.network.cable import Cable, card
from tests.extras.network.places import STRING, text, words_in
from tests.extras.network.two_computers import ADDRESSES, interface

LAUNCH = ('demo_nodes_cpp', 'talker_listener_launch.py')
LASTS_S, LONGEST_S = 10.0, 60.0
DOMAIN = DOMAINS[0]
STRANGE, OURS = 'strange', 'ours'
END = b'end'
TRIES, ANSWERS_S = 4, 1.0


class Voice:
    """Somebody who speaks and listens on /chatter."""

    def __init__(self, link: Link, words: str) -> None:
        self.link, self.words = link, words
        node = link.add_node('/', words)
        self._mouth = link.add(node, PUBLISHER, '/chatter', interface(STRING), QoS())
        link.add(node, SUBSCRIPTION, '/chatter', interface(STRING), QoS())
        self.heard = 0
        self.nodes: set[str] = set()

    def turn(self) -> None:
        self.link.publish(self._mouth, text(self.words))
        self.link.flush()
        select.select([self.link], [], [], 0.05)
        for event in self.link.take():
            self.heard += isinstance(event, Message) and words_in(event.cdr) != self.words
        self.nodes |= {node.name for node in self.link.graph().nodes}


def joined(kind: str, env: dict[str, str]) -> Link:
    link = make_link(kind)
    link.open(settings_of({'ROS_DOMAIN_ID': str(DOMAIN), **env}))
    return link


def own_memory() -> None:
    """Share no memory with other programs, as another computer does not."""
    subprocess.run(['mount', '-t', 'tmpfs', 'none', '/dev/shm'], check=True)


def far(kind: str) -> None:
    """The stranger, until he is asked what he saw."""
    own_memory()
    with socket.socket(fileno=0) as near:
        socket.send_fds(near, [b'.'], [card('far', ADDRESSES[1])])
        near.recv(1)
        voice = Voice(joined(kind, {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST', 'ROS_STATIC_PEERS': ADDRESSES[0]}), STRANGE)
        while not select.select([near], [], [], 0.0)[0]:
            voice.turn()
        while (asked := near.recv(1 << 16)) != END:
            near.send(json.dumps(sum(is_open(port) for port in json.loads(asked))).encode())
        near.send(json.dumps({'heard': voice.heard, 'nodes': sorted(voice.nodes - {STRANGE})}).encode())


def is_open(port: int) -> bool:
    """Whether a packet arrives there: otherwise the kernel answers that nobody listens. It limits the number of its answers."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mouth:
        mouth.connect((ADDRESSES[0], port))
        for _ in range(TRIES):
            try:
                mouth.send(b'')
                if select.select([mouth], [], [], ANSWERS_S)[0]:
                    mouth.recv(1)
            except ConnectionRefusedError:
                return False
    return True


def own_ports() -> list[int]:
    """The ports of all sockets in this namespace of the network that receive packets."""
    rows = [line.split() for line in Path('/proc/net/udp').read_text().splitlines()[1:]]
    return sorted({int(row[1].rpartition(':')[2], 16) for row in rows})


def of_link(kind: str, wide: str, other: socket.socket) -> dict[str, Any]:
    """We are a machine on a link."""
    link = joined(kind, {'ROS_AUTOMATIC_DISCOVERY_RANGE': wide})
    voice, end_s = Voice(link, OURS), time.monotonic() + (LONGEST_S if wide == 'SUBNET' else LASTS_S)
    while time.monotonic() < end_s and not (wide == 'SUBNET' and voice.heard > 5):
        voice.turn()
    ports = own_ports()
    assert len(ports) > 1, ports
    other.send(json.dumps(ports).encode())
    count = json.loads(other.recv(1 << 16))
    link.close()
    return {'driven': voice.heard > 0, 'code': 0, 'open': count}


def of_program(kind: str, wide: str) -> dict[str, Any]:
    """We are `launch --real` or `compare`, which takes the one domain that is free."""
    words = (
        ['launch', '--real', *LAUNCH, '--for', str(LASTS_S)] if kind == 'real' else ['compare', *LAUNCH, '--for', '5', '--json']
    )
    with tempfile.TemporaryDirectory() as folder:
        taken = [open(f'{folder}/edulaunch-{os.getuid()}-domain-{number}', 'w') for number in DOMAINS if number != DOMAIN]  # noqa: SIM115
        for each in taken:
            fcntl.flock(each, fcntl.LOCK_EX)
        env = {**os.environ, 'ROS_DOMAIN_ID': str(DOMAIN), 'ROS_AUTOMATIC_DISCOVERY_RANGE': wide, 'TMPDIR': folder}
        command = [sys.executable, '-m', 'edulaunch', *words]
        done = subprocess.run(command, env=env, capture_output=True, text=True, timeout=120, check=False)
        for each in taken:
            each.close()
    return {'driven': STRANGE in done.stdout + done.stderr, 'code': done.returncode}


def main(kind: str, wide: str) -> None:
    stranger = 'cyclonedds' if kind == 'cyclonedds' else 'rclpy'
    if os.environ.get('FAR'):
        far(stranger)
        return
    own_memory()  # a second test in its own network has the same ports
    ours, theirs = socket.socketpair()
    words = ['unshare', '-nm', sys.executable, '-m', 'tests.extras.network.stranger', *sys.argv[1:]]
    other = subprocess.Popen(words, env={**os.environ, 'FAR': '1'}, stdin=theirs)
    theirs.close()
    try:
        _, [far_end], _, _ = socket.recv_fds(ours, 1, 1)
        Cable((card('near', ADDRESSES[0]), far_end), 0, 0).start()
        ours.send(b'.')
        found = of_program(kind, wide) if kind in ('real', 'compare') else of_link(kind, wide, ours)
        ours.send(END)
        print(json.dumps({**found, **json.loads(ours.recv(1 << 16))}))
    finally:
        other.kill()
        other.wait()


if __name__ == '__main__':
    main(sys.argv[1], sys.argv[2])

"""A cable between two namespaces of the network that takes its time and loses packets: a network card of the kernel's (TAP) in
each, and a thread that carries what comes out of one into the other. (`tc netem` would do it where the kernel has it.)"""

from __future__ import annotations

import fcntl
import os
import random
import select
import socket
import struct
import subprocess
import threading
import time
from collections import deque

SIOCGIFFLAGS, IFF_RUNNING = 0x8913, 0x40
TUNSETIFF, IFF_TAP, IFF_NO_PI = 0x400454CA, 0x0002, 0x1000
LONGEST_FRAME = 65536


def ip(*words: str) -> None:
    subprocess.run(['ip', *words], check=True)


def card(name: str, address: str) -> int:
    """Make a network card in this namespace and switch it on; the number of the file in which its cable ends."""
    end = os.open('/dev/net/tun', os.O_RDWR | os.O_NONBLOCK)
    fcntl.ioctl(end, TUNSETIFF, struct.pack('16sH', name.encode(), IFF_TAP | IFF_NO_PI))
    ip('link', 'set', 'lo', 'up')
    ip('address', 'add', f'{address}/24', 'dev', name)
    ip('link', 'set', name, 'up')
    ip('route', 'add', 'default', 'dev', name)
    wait_until_it_runs(name)
    return end


def wait_until_it_runs(name: str) -> None:
    """Wait until the kernel counts a card as running, some time after it was switched on: DDS leaves out a card that is not."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        end_s = time.monotonic() + 10.0
        while time.monotonic() < end_s:
            flags = struct.unpack('16sH', fcntl.ioctl(asked, SIOCGIFFLAGS, struct.pack('16sH14x', name.encode(), 0))[:18])[1]
            if flags & IFF_RUNNING:
                return
            select.select([], [], [], 0.01)
    raise OSError(f'the card {name} does not run')


class Cable(threading.Thread):
    """Carries frames until the program ends.

    :param lost: how many of 1000 frames it loses, by chance.
    :ivar dropped: how many it has lost.
    """

    def __init__(self, ends: tuple[int, int], lost: int, delay_ms: int) -> None:
        super().__init__(daemon=True)
        self._other = {ends[0]: ends[1], ends[1]: ends[0]}
        self._lost, self._delay_s = lost / 1000, delay_ms / 1000
        self._under_way: deque[tuple[float, int, bytes]] = deque()
        self._chance = random.Random(1)
        self.dropped = 0

    def run(self) -> None:
        while True:
            first = self._under_way[0][0] - time.monotonic() if self._under_way else 1.0
            for end in select.select(list(self._other), [], [], max(0.0, first))[0]:
                self._take(end)
            while self._under_way and self._under_way[0][0] <= time.monotonic():
                _, end, frame = self._under_way.popleft()
                os.write(end, frame)

    def _take(self, end: int) -> None:
        frame = os.read(end, LONGEST_FRAME)
        if self._chance.random() < self._lost:
            self.dropped += 1
        else:
            self._under_way.append((time.monotonic() + self._delay_s, self._other[end], frame))

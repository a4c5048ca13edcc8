"""Machines, their pages and both links at once: `python -m tests.benchmarks.soak MINUTES` says memory and processor time, each minute.

For each link there is a machine with three turtles and their tf, a page that asks for what is new thirty times a second, and a peer. The peer
joins, hears all of it, drives each turtle 50 times a second, and leaves after a while, again and again. Nothing leaves the loopback.
The last lines are the slopes of memory over the second half. `python -m tests.benchmarks.soak MINUTES LINK DOMAIN` has one link only,
cyclonedds or rclpy.
"""

from __future__ import annotations

import os
import select
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from statistics import linear_regression

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.client import hello
from edulaunch.desk.machine.place import Address, folder, read_address
from edulaunch.desk.machine.starting import open_connection
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import PUBLISHER, SUBSCRIPTION, Interface, Message, Settings
from edulaunch.ros.serialization.cdr import encode
from edulaunch.runtime.framing import frame
from tests.benchmarks.network import TURTLES

STAYS_S = 18.0
AWAY_S = 2.0
DRIVE_EVERY_S = 0.02
EVERY_S = 59.0
PICTURE_S = 1 / 30
BOTH = {'cyclonedds': 105, 'rclpy': 106}
HEARD = {'/tf': 'tf2_msgs/msg/TFMessage', **{f'/{name}/turtle1/pose': 'turtlesim/msg/Pose' for name in 'abc'}}


class Visit:
    """The peer, from joining to leaving."""

    def __init__(self, domain: int) -> None:
        registry = underlay_registry()
        self.link = make_link()
        self.link.open(Settings(domain))
        node = self.link.add_node('/', 'driver')
        for topic, type_name in HEARD.items():
            self.link.add(node, SUBSCRIPTION, topic, Interface(type_name, registry), QoS(depth=100))
        twist = Interface('geometry_msgs/msg/Twist', registry)
        self.wheels = [self.link.add(node, PUBLISHER, f'/{name}/turtle1/cmd_vel', twist, QoS()) for name in 'abc']
        self.order = encode(registry.get(twist.name), (2.0, 0.0, 0.0, 0.0, 0.0, 1.0))
        self.link.flush()

    def stay(self) -> int:
        """Drive and hear; how many messages came."""
        heard, end_s = 0, time.monotonic() + STAYS_S
        due_s = time.monotonic()
        while (now_s := time.monotonic()) < end_s:
            if now_s >= due_s:
                due_s += DRIVE_EVERY_S
                for wheel in self.wheels:
                    self.link.publish(wheel, self.order)
                self.link.flush()
            if select.select([self.link], [], [], max(0.0, due_s - now_s))[0]:
                heard += sum(isinstance(event, Message) for event in self.link.take())
        self.link.close()
        return heard


class Page(threading.Thread):
    """A page that asks for what is new, thirty times a second, and takes it."""

    def __init__(self, address: Address) -> None:
        super().__init__(daemon=True)
        found = open_connection(address)
        assert found is not None
        self.connection = found[0]
        self.connection.sendall(hello(address.token, ['machine', 'view'], keyboard=False))
        self.taken = 0
        self.start()

    def run(self) -> None:
        """Until the machine ends."""
        while True:
            self.connection.sendall(frame(wire.INPUT, b'{"op": "next"}\n'))
            due_s = time.monotonic() + PICTURE_S
            while select.select([self.connection], [], [], max(0.0, due_s - time.monotonic()))[0]:
                data = self.connection.recv(1 << 18)
                if not data:
                    return
                self.taken += len(data)


def processes(pid: int) -> list[int]:
    """A machine's process, and its children."""
    children = Path(f'/proc/{pid}/task/{pid}/children').read_text().split()
    return [pid, *(int(child) for child in children)]


def figures(pid: int) -> tuple[float, float]:
    """Megabytes that a process has in memory, and the seconds of a processor that it has used."""
    status = Path(f'/proc/{pid}/status').read_text()
    resident = next(line for line in status.splitlines() if line.startswith('VmRSS'))
    fields = Path(f'/proc/{pid}/stat').read_text().rpartition(')')[2].split()
    return int(resident.split()[1]) / 1024, (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def watch(minutes: float, domain: int) -> None:
    """Visit after visit, and a line a minute."""
    address = read_address(folder(), str(domain))
    assert address is not None
    began_s = said_s = time.monotonic()
    visits = heard = 0
    before = {pid: figures(pid)[1] for pid in processes(address.pid)}
    page, memories = Page(address), dict[int, list[tuple[float, float]]]()
    while time.monotonic() - began_s < minutes * 60:
        heard += Visit(domain).stay()
        visits += 1
        time.sleep(AWAY_S)
        now_s = time.monotonic()
        if now_s - said_s >= EVERY_S:
            now = {pid: figures(pid) for pid in processes(address.pid)}
            for pid, (megabytes, _) in now.items():
                memories.setdefault(pid, []).append(((now_s - began_s) / 3600, megabytes))
            shares = [(used - before.get(pid, 0.0)) / (now_s - said_s) * 100 for pid, (_, used) in now.items()]
            memory = [f'{megabytes:.1f} MB {share:.1f} %' for (megabytes, _), share in zip(now.values(), shares, strict=True)]
            load = os.getloadavg()[0]
            text = (
                f'{(now_s - began_s) / 60:5.1f} min  {visits} visits  {heard} heard  {"  side: ".join(memory)}'
                f'  page {page.taken / 1e6:.1f} MB {"open" if page.is_alive() else "CLOSED"}  load {load:.1f}'
            )
            print(text, flush=True)
            before, said_s = {pid: used for pid, (_, used) in now.items()}, now_s
    for pid, points in memories.items():
        half = points[len(points) // 2 :]
        if len(half) > 1:
            print(f'process {pid}: {linear_regression(*zip(*half, strict=True)).slope:+.1f} MB an hour in the second half')


def soak(minutes: float, link: str, domain: int) -> None:
    """A machine of its own, from its start to its end."""
    with tempfile.TemporaryDirectory() as place:
        os.environ.update(XDG_RUNTIME_DIR=place, ROS_DOMAIN_ID=str(domain), ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
        file = Path(place) / 'turtles.launch.py'
        file.write_text(TURTLES)
        edulaunch = [sys.executable, '-c', 'import sys; from edulaunch.desk.cli.main import main; sys.exit(main())']
        ros2 = [sys.executable, '-c', 'import sys; from edulaunch.desk.machine.command import ros2; sys.exit(ros2())']
        subprocess.run([*edulaunch, 'network', 'on', '--link', link], check=True)
        launch = subprocess.Popen([*ros2, 'launch', str(file)], stdout=subprocess.DEVNULL)
        try:
            watch(minutes, domain)
            subprocess.run([*edulaunch, 'network', 'status'], check=True)
        finally:
            launch.terminate()
            launch.wait()
            subprocess.run([*edulaunch, 'machine', 'stop'], check=True)


def both(minutes: str) -> int:
    """A soak of each link at the same time; how many failed."""
    words = [sys.executable, '-u', '-m', 'tests.benchmarks.soak', minutes]
    runs = [subprocess.Popen([*words, link, str(domain)]) for link, domain in BOTH.items()]
    return sum(run.wait() != 0 for run in runs)


if __name__ == '__main__':
    if len(sys.argv) == 2:
        sys.exit(both(sys.argv[1]))
    soak(float(sys.argv[1]), sys.argv[2], int(sys.argv[3]))

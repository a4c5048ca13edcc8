"""Machines, their pages and both links at once: `python -m tests.benchmarks.soak MINUTES` says what each process holds, each minute.

For each link there is a machine with three turtles, their tf and a node on rclpy that counts; the server of the live view with a page that
asks for what is new thirty times a second; and a peer. The peer joins, hears all of it, drives each turtle 50 times a second, and leaves
after a while, again and again. Both sides number what they publish, so that each hears what it has lost. Nothing leaves the loopback.

The last lines are the slopes over the second half: memory, files and threads of each process. `python -m tests.benchmarks.soak MINUTES
LINK DOMAIN` has one link only, cyclonedds or rclpy. The exit code says whether something was lost, or a page closed.
"""

from __future__ import annotations

import asyncio
import os
import select
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from statistics import linear_regression
from typing import NamedTuple
from urllib.parse import urlsplit

from edulaunch.desk.machine.place import folder, read_address
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import PUBLISHER, SUBSCRIPTION, Interface, Message, Settings
from edulaunch.ros.serialization.cdr import decode, encode
from tests.benchmarks.network import TURTLES

STAYS_S = 18.0
SILENT_S = 2.0
"""The last seconds of a visit, in which the peer only hears: what it has said must have arrived then."""
AWAY_S = 2.0
SAY_EVERY_S = 0.02
EVERY_S = 59.0
PICTURE_S = 1 / 30
A_VISIT = 10**6
"""The numbers of one visit begin at a multiple of this."""
BOTH = {'cyclonedds': 105, 'rclpy': 106}
HEARD = {'/tf': 'tf2_msgs/msg/TFMessage', **{f'/{name}/turtle1/pose': 'turtlesim/msg/Pose' for name in 'abc'}}
COUNTING = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Counting(Node):
    def __init__(self):
        super().__init__('counting')
        self.said = self.last = self.lost = 0
        self.publisher = self.create_publisher(String, '/said', 100)
        self.create_subscription(String, '/asked', self.hear, 1000)
        self.create_timer(0.02, self.say)

    def hear(self, message):
        number = int(message.data)
        if number // 10**6 == self.last // 10**6:
            self.lost += abs(number - self.last - 1)
        self.last = number

    def say(self):
        self.said += 1
        self.publisher.publish(String(data=f'{self.said} {self.last} {self.lost}'))


rclpy.init()
rclpy.spin(Counting())
"""
LAUNCH = f"""{TURTLES}

from launch.actions import ExecuteProcess

def turtles(described=generate_launch_description):
    description = described()
    description.add_action(ExecuteProcess(cmd=['python3', 'counting.py'], output='screen'))
    return description

generate_launch_description = turtles
"""


class Tally:
    """What was heard and lost in all visits.

    :ivar lost: messages of the counting node that the peer did not get.
    :ivar lost_inward: messages of the peer that the counting node did not get.
    """

    def __init__(self) -> None:
        self.visits = self.heard = self.counted = self.asked = self.lost = self.lost_inward = 0

    def __str__(self) -> str:
        return f'{self.visits} visits  {self.heard} heard  out {self.counted} lost {self.lost}  in {self.asked} lost {self.lost_inward}'


class Visit:
    """The peer, from joining to leaving."""

    def __init__(self, domain: int, tally: Tally) -> None:
        registry, self.tally = underlay_registry(), tally
        self.link = make_link()
        self.link.open(Settings(domain))
        node = self.link.add_node('/', 'driver')
        for topic, type_name in HEARD.items():
            self.link.add(node, SUBSCRIPTION, topic, Interface(type_name, registry), QoS(depth=100))
        twist, string = (Interface(name, registry) for name in ('geometry_msgs/msg/Twist', 'std_msgs/msg/String'))
        self.wheels = [self.link.add(node, PUBLISHER, f'/{name}/turtle1/cmd_vel', twist, QoS()) for name in 'abc']
        self.asking = self.link.add(node, PUBLISHER, '/asked', string, QoS(depth=1000))
        self.counted = self.link.add(node, SUBSCRIPTION, '/said', string, QoS(depth=1000))
        self.order, self.string = encode(registry.get(twist.name), (2.0, 0.0, 0.0, 0.0, 0.0, 1.0)), registry.get(string.name)
        self.said, self.last = (tally.visits + 1) * A_VISIT, 0
        self.arrived = [0, 0]
        self.link.flush()

    def stay(self) -> None:
        """Drive, ask and hear."""
        end_s = time.monotonic() + STAYS_S
        due_s = time.monotonic()
        while (now_s := time.monotonic()) < end_s:
            if now_s >= due_s:
                due_s += SAY_EVERY_S
                if now_s < end_s - SILENT_S:
                    self.say()
            if select.select([self.link], [], [], max(0.0, due_s - now_s))[0]:
                for event in self.link.take():
                    if isinstance(event, Message):
                        self.hear(event)
        self.link.close()
        arrived, lost = self.arrived
        self.tally.visits += 1
        self.tally.lost_inward = lost + (self.said - arrived if arrived // A_VISIT == self.said // A_VISIT else A_VISIT)

    def say(self) -> None:
        """One order for each turtle, and one number for the counting node."""
        for wheel in self.wheels:
            self.link.publish(wheel, self.order)
        self.said += 1
        self.tally.asked += 1
        self.link.publish(self.asking, encode(self.string, (str(self.said),)))
        self.link.flush()

    def hear(self, event: Message) -> None:
        """Count a message; those of the counting node have to follow each other."""
        self.tally.heard += 1
        if event.handle == self.counted:
            number, *self.arrived = map(int, decode(self.string, event.cdr)[0].split())
            if self.last:
                self.tally.lost += abs(number - self.last - 1)
            self.last = number
            self.tally.counted += 1


class Page(threading.Thread):
    """The server of the live view, and a page that asks it for what is new, thirty times a second, and takes it."""

    def __init__(self) -> None:
        super().__init__(daemon=True)
        words = [sys.executable, '-m', 'edulaunch', 'view', '--no-browser']
        self.server = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
        assert self.server.stdout is not None
        self.address = self.server.stdout.readline().split()[-1]
        self.taken = 0
        self.start()

    def run(self) -> None:
        """Until the server ends."""
        asyncio.run(self._watch())

    async def _watch(self) -> None:
        from tornado.httpclient import HTTPRequest
        from tornado.websocket import websocket_connect

        own = urlsplit(self.address)
        request = HTTPRequest(f'ws://{own.netloc}{own.path}socket', headers={'Origin': f'http://{own.netloc}'})
        page = await websocket_connect(request, max_message_size=1 << 28)

        async def ask() -> None:
            while True:
                await page.write_message('{"op": "next"}')
                await asyncio.sleep(PICTURE_S)

        asking = asyncio.create_task(ask())
        while (message := await page.read_message()) is not None:
            self.taken += len(message)
        asking.cancel()


class Figures(NamedTuple):
    """What a process holds now, and the seconds of a processor that it has used."""

    megabytes: float
    files: int
    threads: int
    used_s: float


def processes(pid: int) -> list[int]:
    """A machine's process, and its children."""
    children = Path(f'/proc/{pid}/task/{pid}/children').read_text().split()
    return [pid, *(int(child) for child in children)]


def figures(pid: int) -> Figures:
    """Read them."""
    status = dict(line.split(':', 1) for line in Path(f'/proc/{pid}/status').read_text().splitlines())
    fields = Path(f'/proc/{pid}/stat').read_text().rpartition(')')[2].split()
    used_s = (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')
    return Figures(int(status['VmRSS'].split()[0]) / 1024, len(os.listdir(f'/proc/{pid}/fd')), int(status['Threads']), used_s)


class Watch:
    """The figures of all processes, minute by minute."""

    def __init__(self, machine: int, page: Page) -> None:
        self.machine, self.page = machine, page
        self.began_s = self.said_s = time.monotonic()
        self.samples: dict[str, list[tuple[float, Figures]]] = {}
        self.before = {name: figures(pid) for name, pid in self.pids().items()}

    def pids(self) -> dict[str, int]:
        """The processes by name."""
        own, *children = processes(self.machine)
        return {'machine': own, **{f'side {pid}': pid for pid in children}, 'page server': self.page.server.pid}

    def minute(self, tally: Tally) -> None:
        """Print a line, once a minute."""
        now_s = time.monotonic()
        if now_s - self.said_s < EVERY_S:
            return
        now, texts = {name: figures(pid) for name, pid in self.pids().items()}, []
        for name, each in now.items():
            self.samples.setdefault(name, []).append(((now_s - self.began_s) / 3600, each))
            used_s = each.used_s - (self.before[name].used_s if name in self.before else 0.0)
            share = used_s / (now_s - self.said_s)
            texts.append(f'{name}: {each.megabytes:.1f} MB {each.files} files {each.threads} threads {share:.1%}')
        page = f'page {self.page.taken / 1e6:.1f} MB {"open" if self.page.is_alive() else "CLOSED"}'
        head = f'{(now_s - self.began_s) / 60:5.1f} min  {tally}'
        print(head, *texts, page, f'load {os.getloadavg()[0]:.1f}', sep='  ', flush=True)
        self.before, self.said_s = now, now_s

    def slopes(self) -> None:
        """Print what each process gains in an hour, in the second half."""
        for name, samples in self.samples.items():
            half = samples[len(samples) // 2 :]
            if len(half) > 1:
                hours = [hour for hour, _ in half]
                slopes = [
                    linear_regression(hours, values).slope for values in list(zip(*(each for _, each in half), strict=True))[:3]
                ]
                print(f'{name}: {slopes[0]:+.2f} MB, {slopes[1]:+.2f} files, {slopes[2]:+.2f} threads an hour in the second half')


def watch(minutes: float, domain: int) -> bool:
    """Visit after visit, and a line a minute; whether nothing was lost and the page stayed open."""
    address = read_address(folder(), str(domain))
    assert address is not None
    page, tally = Page(), Tally()
    try:
        watched = Watch(address.pid, page)
        while time.monotonic() - watched.began_s < minutes * 60:
            Visit(domain, tally).stay()
            time.sleep(AWAY_S)
            watched.minute(tally)
        watched.slopes()
        print(tally, flush=True)
        return page.is_alive() and not tally.lost and not tally.lost_inward and tally.counted > 0
    finally:
        page.server.terminate()
        page.server.wait()


def soak(minutes: float, link: str, domain: int) -> bool:
    """A machine of its own, from its start to its end."""
    with tempfile.TemporaryDirectory() as place:
        os.environ.update(XDG_RUNTIME_DIR=place, ROS_DOMAIN_ID=str(domain), ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
        Path(place, 'turtles.launch.py').write_text(LAUNCH)
        Path(place, 'counting.py').write_text(COUNTING)
        edulaunch = [sys.executable, '-m', 'edulaunch']
        subprocess.run([*edulaunch, 'network', 'on', '--link', link], check=True)
        launch = subprocess.Popen([*edulaunch, 'ros2', 'launch', 'turtles.launch.py'], stdout=subprocess.DEVNULL, cwd=place)
        try:
            time.sleep(5.0)
            whole = watch(minutes, domain)
            subprocess.run([*edulaunch, 'network', 'status'], check=True)
            return whole
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
    sys.exit(not soak(float(sys.argv[1]), sys.argv[2], int(sys.argv[3])))

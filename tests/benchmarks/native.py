"""What the real rclpy costs: `python -m tests.benchmarks.native` (needs `edulaunch network install`; everything on the loopback).

A node on it with our messages against a plain one, each from the start of its process to the node; and how long a real client
waits for an answer over the full link.
"""

from __future__ import annotations

import os
import select
import statistics
import subprocess
import tempfile
import time

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native.command import command
from edulaunch.extras.native.environment import needed
from edulaunch.extras.network.network_link import SERVICE, Interface, Request, Settings
from edulaunch.extras.network.rclpy_link import RclpyLink

DOMAIN = 58
START = """
import os, time
import rclpy
rclpy.init()
rclpy.create_node('started')
print(time.time() - float(os.environ['BEGAN']))
"""
CALLS = """
import time
import rclpy
from std_srvs.srv import Empty
rclpy.init()
node = rclpy.create_node('caller')
client = node.create_client(Empty, '/empty')
client.wait_for_service()
for _ in range(300):
    began = time.perf_counter()
    rclpy.spin_until_future_complete(node, client.call_async(Empty.Request()))
    print(time.perf_counter() - began, flush=True)
"""


def words_for(text: str, folder: str) -> tuple[list[str], list[str]]:
    """How a script is run with our messages, and plainly."""
    file = os.path.join(folder, 'program.py')
    with open(file, 'w') as out:
        out.write(text)
    program = Program('script', '', 'program', file, file=file)
    environment = needed()
    return [*command(environment, program, ProcessSpec((), 'program'), Index()), file], [environment.python, file]


def run(words: list[str]) -> str:
    """Run to the end; what it says."""
    env = {**os.environ, 'ROS_DOMAIN_ID': str(DOMAIN), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST', 'BEGAN': str(time.time())}
    return subprocess.run(words, env=env, capture_output=True, text=True, check=True).stdout


def starts(folder: str) -> None:
    """From the start of a process to its node, in turns."""
    ours, plain = words_for(START, folder)
    times = [(float(run(ours)), float(run(plain))) for _ in range(10)]
    with_ours, without = (statistics.median(column) for column in zip(*times, strict=True))
    print(f'to the first node, median of 10: with our messages {with_ours:.2f} s, plain {without:.2f} s')


def calls(folder: str) -> None:
    """A real client of a service that is answered over the full link."""
    link = RclpyLink()
    link.open(Settings(DOMAIN))
    try:
        interface = Interface('std_srvs/srv/Empty', underlay_registry())
        service = link.add(link.add_node('/', 'server'), SERVICE, '/empty', interface, QoS())
        link.flush()
        env = {**os.environ, 'ROS_DOMAIN_ID': str(DOMAIN), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}
        child = subprocess.Popen(words_for(CALLS, folder)[0], env=env, stdout=subprocess.PIPE, text=True)
        while child.poll() is None:
            select.select([link], [], [], 0.1)
            for event in link.take():
                if isinstance(event, Request):
                    link.reply(service, event.who, b'\x00\x01\x00\x00\x00')
            link.flush()
        waits = sorted(float(line) * 1e3 for line in child.communicate()[0].split())
        middle, late = statistics.median(waits), waits[-15]
        print(f'a call over the full link, {len(waits)} calls: median {middle:.1f} ms, 95 of 100 within {late:.1f} ms')
    finally:
        link.close()


if __name__ == '__main__':
    with tempfile.TemporaryDirectory() as place:
        starts(place)
        calls(place)

"""What a message, a service call and a node cost through rclpy's face, in microseconds, beside the least that bare Python can do.

Two nodes of one program; the publisher sends bursts of small messages (String) from a timer, so that timers cost next to nothing.
The bare loop copies each message into a queue and calls the callback with another copy.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections import deque
from typing import Any

import edulaunch

ROUNDS = 5
BURST = 50
BURSTS = 200
CALLS = 3000
NODES = 1000


def bare_message_us() -> float:
    """Copy, queue, copy, call."""

    class Message:
        __slots__ = ('data',)

        def __init__(self, data: str) -> None:
            self.data = data

    def callback(message: Message) -> None:
        seen.append(message.data)

    seen: deque[str] = deque(maxlen=10)
    waiting: deque[tuple[str]] = deque()
    message = Message('hello')
    began = time.process_time()
    for _ in range(BURSTS):
        for _ in range(BURST):
            waiting.append((message.data,))
        while waiting:
            callback(Message(*waiting.popleft()))
    return (time.process_time() - began) / (BURST * BURSTS) * 1e6


def message_us() -> float:
    """Publish to callback."""
    import rclpy
    from std_msgs.msg import String

    rclpy.init()
    talker, listener = rclpy.create_node('talker'), rclpy.create_node('listener')
    publisher = talker.create_publisher(String, 'chatter', BURST)
    message, count = String(data='hello'), 0

    def callback(message: Any) -> None:
        nonlocal count
        count += 1

    def burst() -> None:
        for _ in range(BURST):
            publisher.publish(message)

    listener.create_subscription(String, 'chatter', callback, BURST)
    talker.create_timer(0.01, burst)
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(talker)
    executor.add_node(listener)
    done = rclpy.task.Future()
    talker.create_timer(0.01 * BURSTS + 0.005, lambda: done.set_result(None))
    began = time.process_time()
    executor.spin_until_future_complete(done)
    took = time.process_time() - began
    for node in (talker, listener):
        node.destroy_node()
    rclpy.shutdown()
    if count != BURSTS * BURST:
        raise SystemExit(f'{count} messages came of {BURSTS * BURST}: simulated time kept pace with real time')
    return took / count * 1e6


def service_us(*, wait: bool) -> float:
    """Request to response: `call_async` with a callback that asks again, or `spin_until_future_complete` for each."""
    import rclpy
    from example_interfaces.srv import AddTwoInts

    rclpy.init()
    node = rclpy.create_node('both')

    def answer(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, 'add', answer)
    client = node.create_client(AddTwoInts, 'add')
    request, done, left = AddTwoInts.Request(a=1, b=2), rclpy.task.Future(), CALLS

    def ask(previous: Any = None) -> None:
        nonlocal left
        left -= 1
        if left < 0:
            done.set_result(None)
        else:
            client.call_async(request).add_done_callback(ask)

    began = time.process_time()
    if wait:
        for _ in range(CALLS):
            rclpy.spin_until_future_complete(node, client.call_async(request))
    else:
        ask()
        rclpy.spin_until_future_complete(node, done)
    took = time.process_time() - began
    node.destroy_node()
    rclpy.shutdown()
    return took / CALLS * 1e6


NODES_SCRIPT = f"""
import time
import edulaunch


def rss_mb():
    with open('/proc/self/statm') as file:
        return int(file.read().split()[1]) * 4096 / 1e6
edulaunch.source()
import rclpy
rclpy.init()
rclpy.create_node('first').create_timer(1.0, lambda: None)
executor = rclpy.executors.SingleThreadedExecutor()
before, began = rss_mb(), time.process_time()
nodes = [rclpy.create_node(f'node_{{i}}') for i in range({NODES})]
for node in nodes:
    node.create_timer(1.0, lambda: None)
    executor.add_node(node)
executor.spin_once(timeout_sec=1.5)
print(time.process_time() - began, rss_mb() - before)
"""


def thousand_nodes() -> tuple[float, float]:
    """Seconds until 1000 nodes with a timer each run, and megabytes that they add; in a fresh interpreter (Linux)."""
    run = subprocess.run([sys.executable, '-c', NODES_SCRIPT], capture_output=True, text=True, check=True)
    seconds, megabytes = run.stdout.split()
    return float(seconds), float(megabytes)


def measure() -> dict[str, float]:
    """Name -> figure; the least of several rounds."""
    edulaunch.source()
    message = min(message_us() for _ in range(ROUNDS))
    bare = min(bare_message_us() for _ in range(ROUNDS))
    nodes = [thousand_nodes() for _ in range(3)]
    return {
        'publish to callback (us)': message,
        'publish to callback / bare loop': message / bare,
        'service round trip, callback (us)': min(service_us(wait=False) for _ in range(ROUNDS)),
        'service round trip, spin_until_future_complete (us)': min(service_us(wait=True) for _ in range(ROUNDS)),
        '1000 nodes with a timer (s)': min(seconds for seconds, _ in nodes),
        '1000 nodes with a timer (MB)': min(megabytes for _, megabytes in nodes),
    }


if __name__ == '__main__':
    from run import figures_of  # in a program of its own: a script that knows Python's `time` runs in real time, and is late

    for name, value in figures_of('messages').items():
        print(f'{name:<56} {value:>10.2f}')

"""tf through the Python API: a latest lookup, and a random old one over a growing history."""
from __future__ import annotations

import random
import time
from typing import Any

import edulaunch


def chain(frames: int, samples: int) -> Any:
    """A buffer with world -> f1 -> ... , each with `samples` transforms 10 ms apart."""
    edulaunch.source()
    from geometry_msgs.msg import TransformStamped
    from rclpy.duration import Duration
    from tf2_ros import Buffer
    buffer = Buffer(cache_time=Duration(seconds=samples))
    for sample in range(1, samples + 1):
        for number in range(frames):
            stamped = TransformStamped()
            stamped.header.frame_id = 'world' if number == 0 else f'f{number}'
            stamped.child_frame_id = f'f{number + 1}'
            stamped.header.stamp.sec, stamped.header.stamp.nanosec = divmod(sample * 10_000_000, 10**9)
            stamped.transform.translation.x = float(sample)
            buffer.set_transform(stamped, 'benchmark')
    return buffer


def lookup_us(buffer: Any, frame: str, times: list[Any], rounds: int = 5) -> float:
    """The median cost of one lookup in microseconds."""
    lookup, taken = buffer.lookup_transform, []
    for _ in range(rounds):
        began = time.perf_counter()
        for when in times:
            lookup('world', frame, when)
        taken.append((time.perf_counter() - began) / len(times) * 1e6)
    return sorted(taken)[rounds // 2]


def measure() -> dict[str, float]:
    """Microseconds per lookup."""
    edulaunch.source()
    from rclpy.time import Time
    chance = random.Random(0)
    found = {'latest, 3 frames (us)': lookup_us(chain(3, 100), 'f3', [Time()] * 5000)}
    for samples in (100, 1000, 10_000):
        old = [Time(nanoseconds=chance.randrange(10_000_000, samples * 10_000_000)) for _ in range(5000)]
        found[f'random old time, 3 frames, {samples} samples (us)'] = lookup_us(chain(3, samples), 'f3', old)
    return found


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.2f}')

"""tf through the Python API: a latest lookup, and a random old one over a growing history; and the same of the numeric core.

The frames turn about the z axis, as on a floor, which takes a shorter way; frames turned about any axis are measured beside them,
and frames that are not turned at all, which need not be interpolated on the sphere.
"""

from __future__ import annotations

import random
import time
from typing import Any

import edulaunch


def chain(frames: int, samples: int, turn: tuple[float, ...] = (0.0, 0.0, 0.28, 0.96)) -> Any:
    """A buffer with world -> f1 -> ... , each with `samples` transforms 10 ms apart, turned by a quaternion."""
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
            rotation = stamped.transform.rotation
            rotation.x, rotation.y, rotation.z, rotation.w = turn
            rotation.z *= 1 - sample % 2 * 2
            buffer.set_transform(stamped, 'benchmark')
    return buffer


def lookup_us(lookup: Any, frame: str, times: list[Any], rounds: int = 7) -> float:
    """The least cost of one lookup in microseconds."""
    taken = []
    for _ in range(rounds):
        began = time.process_time()
        for when in times:
            lookup('world', frame, when)
        taken.append((time.process_time() - began) / len(times) * 1e6)
    return min(taken)


def set_us(rounds: int = 5) -> float:
    """The least cost of one `set_transform` of the numeric core in microseconds, 10 ms apart, with a history of 10 s."""
    from edulaunch.engine.tf import TransformBuffer

    taken = []
    for _ in range(rounds):
        buffer = TransformBuffer()
        store, pose = buffer.set, (1.0, 2.0, 0.0, 0.0, 0.0, 0.6, 0.8)
        began = time.process_time()
        for sample in range(1, 5001):
            store('world', 'turtle1', sample * 10_000_000, pose)
        taken.append((time.process_time() - began) / 5000 * 1e6)
    return min(taken)


def measure() -> dict[str, float]:
    """Microseconds per lookup, and per transform that is stored."""
    edulaunch.source()
    from rclpy.time import Time

    chance = random.Random(0)
    found = {'set (us)': set_us()}
    for frames in (3, 10, 50):
        name, latest = f'latest, {frames} frames', chain(frames, 100)
        found[f'{name} (us)'] = lookup_us(latest.lookup_transform, f'f{frames}', [Time()] * 2000)
        found[f'{name}, numeric core (us)'] = lookup_us(latest._tf.lookup, f'f{frames}', [0] * 2000)
        turned = chain(frames, 100, (0.5, -0.5, 0.1, 0.7))
        found[f'{name}, turned about any axis (us)'] = lookup_us(turned.lookup_transform, f'f{frames}', [Time()] * 2000)
    for frames, samples in ((3, 100), (3, 1000), (3, 10_000), (50, 1000)):
        name, history = f'random old time, {frames} frames, {samples} samples', chain(frames, samples)
        old = [chance.randrange(10_000_000, samples * 10_000_000) for _ in range(2000)]
        times = [Time(nanoseconds=when) for when in old]
        found[f'{name} (us)'] = lookup_us(history.lookup_transform, f'f{frames}', times)
        found[f'{name}, numeric core (us)'] = lookup_us(history._tf.lookup, f'f{frames}', old)
        straight = chain(frames, samples, (0.0, 0.0, 0.0, 1.0))
        found[f'{name}, not turned (us)'] = lookup_us(straight.lookup_transform, f'f{frames}', times)
    return found


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.2f}')

"""How long pictures and replays take once matplotlib is loaded."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import edulaunch

LAUNCH_FILE = Path(__file__).with_name('large_project.launch.py')


def best_ms(make: Callable[[], Any], rounds: int = 5) -> float:
    """The shortest CPU time of several rounds, in milliseconds; the first one loads what is loaded once."""
    make()
    times = []
    for _ in range(rounds):
        began = time.process_time()
        make()
        times.append(time.process_time() - began)
    return min(times) * 1e3


def measure() -> dict[str, float]:
    """Milliseconds of the large project: stills of a 20 s run, a replay of a 60 s run and its size in kilobytes."""
    short = edulaunch.run(LAUNCH_FILE, duration_s=20.0)
    found = {
        f'{name[5:]} (ms)': best_ms(lambda name=name: getattr(short, name)().png())
        for name in ('plot_turtles', 'plot_frames', 'plot_tf_tree', 'plot_graph')
    }
    found['replay of 20 s (kB)'] = len(short.replay().html()) / 1e3
    data = edulaunch.run(LAUNCH_FILE, duration_s=60.0).to_bytes()
    found['replay of 60 s (ms)'] = best_ms(lambda: edulaunch.Recording.from_bytes(data).replay().html(), 3)
    return found


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.1f}')

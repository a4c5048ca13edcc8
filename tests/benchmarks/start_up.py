"""How long commands take from the shell, beside a bare interpreter."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent


def least_s(command: list[str], rounds: int = 11, ok: tuple[int, ...] = (0,)) -> float:
    """The least wall time of a command: whatever else the machine does can only add to it."""
    times = []
    for _ in range(rounds):
        began = time.perf_counter()
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        times.append(time.perf_counter() - began)
        if done.returncode not in ok:
            raise SystemExit(f'{" ".join(command)} ended with {done.returncode}')
    return min(times)


def measure() -> dict[str, float]:
    """Milliseconds; imports without the bare interpreter."""
    bare = least_s([sys.executable, '-c', 'pass'])
    setup = 'import edulaunch; edulaunch.source()'
    sourced = least_s([sys.executable, '-c', setup])
    return {
        'bare interpreter (ms)': bare * 1e3,
        'import edulaunch (ms)': (least_s([sys.executable, '-c', 'import edulaunch']) - bare) * 1e3,
        'import launch, launch_ros (ms)': (least_s([sys.executable, '-c', f'{setup}; import launch, launch_ros']) - sourced)
        * 1e3,
        'edugrade solutions/circle.launch.py (ms)': least_s([str(BIN / 'edugrade'), 'solutions/circle.launch.py']) * 1e3,
    }


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.1f}')

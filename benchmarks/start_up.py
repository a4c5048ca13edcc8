"""How long commands take from the shell, beside a bare interpreter."""
from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BIN = Path(sys.executable).parent


def median_s(command: list[str], rounds: int = 7, ok: tuple[int, ...] = (0,)) -> float:
    """The median wall time of a command."""
    times = []
    for _ in range(rounds):
        began = time.perf_counter()
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        times.append(time.perf_counter() - began)
        if done.returncode not in ok:
            raise SystemExit(f'{" ".join(command)} ended with {done.returncode}')
    return sorted(times)[rounds // 2]


def measure() -> dict[str, float]:
    """Milliseconds; imports without the bare interpreter."""
    bare = median_s([sys.executable, '-c', 'pass'])
    setup = 'import edulaunch; edulaunch.source()'
    sourced = median_s([sys.executable, '-c', setup])
    return {
        'bare interpreter (ms)': bare * 1e3,
        'import edulaunch (ms)': (median_s([sys.executable, '-c', 'import edulaunch']) - bare) * 1e3,
        'import launch, launch_ros (ms)': (median_s([sys.executable, '-c', f'{setup}; import launch, launch_ros'])
                                           - sourced) * 1e3,
        'edugrade solutions/circle.launch.py (ms)': median_s([str(BIN / 'edugrade'), 'solutions/circle.launch.py']) * 1e3,
    }


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.1f}')

"""How long grading takes: one submission, a class on this computer, and the same class on two Dask workers.

    python -m tests.benchmarks.grading [SUBMISSIONS] [PAIRS]

The two figures of a pair are measured one after the other. The ratio is that of each pair, so a busy computer changes it less.
The load average of the last minute is printed beside them. Four of 200 submissions never end or crash.

Measured on 23 November 2026 while other programs ran (load 2 to 3), in pairs with the commit before the early starter:

- One file takes 0.85 of the real time and 0.95 of the processor time. Its median is 0.56 s. We want 0.35 s.
- A class of 24 takes 0.84 of the real time and 0.90 of the processor time. Its best rate is 5.0 submissions a second. We want 8.
- The trusted peers of the runs need 40 % of a submission's processor time, and the confined peers and guards 30 %. The workers
  that judge need 19 %, and reading the recordings 11 %.
- Loading the engine and the first simulation in the starter take half of the real time of one file.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CIRCLE = (ROOT / 'solutions' / 'circle.launch.py').read_text()
BAD = ('\nwhile True:\n    pass\n', '\nraise ValueError("x")\n', '\nimport os\nos._exit(1)\n', '\nx = [0] * (1 << 40)\n')
CLUSTER = """
import sys
from distributed import LocalCluster
if __name__ == '__main__':
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, host='127.0.0.1') as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()
"""


def seconds(command: list[str]) -> float:
    """How long a command takes."""
    began = time.perf_counter()
    subprocess.run(command, cwd='/', stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return time.perf_counter() - began


def edugrade(*words: str) -> list[str]:
    """The command edugrade of this environment."""
    return [os.path.join(os.path.dirname(sys.executable), 'edugrade'), *words]


def handed_in(folder: Path, count: int) -> Path:
    """A class of which 2 % hand in something bad, and the others the solution with a remark of their own."""
    for number in range(count):
        place = folder / 'class' / f'student{number:03}'
        place.mkdir(parents=True)
        bad = BAD[number // 50 % len(BAD)] if number % 50 == 10 else f'# student {number}\n'
        (place / 'circle.launch.py').write_text(CIRCLE + bad)
    return folder / 'class'


def pairs(one: Callable[[], float], other: Callable[[], float], count: int) -> tuple[float, float, float]:
    """The medians of both, and of the ratio of each pair."""
    found = [(one(), other()) for _ in range(count)]
    return (
        statistics.median(first for first, _ in found),
        statistics.median(second for _, second in found),
        statistics.median(first / second for first, second in found),
    )


def main(count: int = 100, times: int = 3) -> None:
    """Print all figures."""
    circle = str(ROOT / 'solutions' / 'circle.launch.py')
    confined, bare, ratio = pairs(
        lambda: seconds(edugrade(circle)), lambda: seconds([sys.executable, '-c', 'import edulaunch.runtime.session']), 3 * times
    )
    print(f'load {os.getloadavg()[0]:.1f}: circle, confined: {confined:.3f} s; {ratio:.2f} times a Python that loads sessions')
    off, on, ratio = pairs(lambda: seconds(edugrade(circle, '--sandbox', 'off')), lambda: seconds(edugrade(circle)), 3 * times)
    print(f'load {os.getloadavg()[0]:.1f}: without a sandbox {off:.3f} s, confined {on:.3f} s: {ratio:.2f}')
    with tempfile.TemporaryDirectory() as place:
        group = handed_in(Path(place), count)
        (Path(place) / 'cluster.py').write_text(CLUSTER)
        results = iter(range(1000))

        def batch(*words: str) -> float:
            return seconds(edugrade('batch', str(group), '--out', f'{place}/results{next(results)}', *words))

        with subprocess.Popen(
            [sys.executable, f'{place}/cluster.py'], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=place
        ) as cluster:
            assert cluster.stdout is not None
            address = cluster.stdout.readline().strip()
            batch('--dask', address)  # the workers load the engine
            there, here, ratio = pairs(lambda: batch('--dask', address), batch, times)
            cluster.communicate('')
    print(f'load {os.getloadavg()[0]:.1f}: {count} submissions here: {count / here:.1f} a second')
    print(
        f'load {os.getloadavg()[0]:.1f}: on two Dask workers: {count / there:.1f} a second; Dask takes {ratio:.2f} times as long'
    )


if __name__ == '__main__':
    main(*map(int, sys.argv[1:3]))

"""All benchmarks in one run, beside what they should reach:  python benchmarks/run.py

Each part runs in an interpreter of its own, as what it measures does: a heap full of another part's objects costs up to a tenth.
"""

from __future__ import annotations

import json
import platform
import subprocess
import sys
from pathlib import Path

WANTED = {
    'times real time': 'at least 250',
    'times the bare loop': 'at most 8',
    'import edulaunch (ms)': 'under 30',
    'import launch, launch_ros (ms)': 'under 40',
    'edugrade solutions/circle.launch.py (ms)': 'under 800',
    'publish to callback (us)': 'under 4',
    'service round trip, callback (us)': 'under 15',
    'service round trip, spin_until_future_complete (us)': 'under 15',
    '1000 nodes with a timer (s)': 'under 0.5',
    '1000 nodes with a timer (MB)': 'under 60',
    'set (us)': 'under 1.5',
    'latest, 3 frames (us)': 'under 3',
    'latest, 10 frames (us)': 'under 8',
    'latest, 50 frames (us)': 'under 40',
    'random old time, 3 frames, 1000 samples (us)': 'under 5',
    'random old time, 50 frames, 1000 samples (us)': 'under 85',
    'plan of 1000 nodes, Python (ms)': 'under 250',
    'plan of 1000 nodes, XML (ms)': 'under 250',
    'plan of 1000 nodes, YAML (ms)': 'under 250',
    '1000 nodes, Python (ms)': 'under 100',
    '1000 nodes, XML (ms)': 'under 120',
    '1000 nodes, YAML (ms)': 'under 120',
    '5000 nodes / 1000 nodes, Python': 'about 5',
    '5000 nodes / 1000 nodes, XML': 'about 5',
    '5000 nodes / 1000 nodes, YAML': 'about 5',
    '1000 nodes / bare work, Python': 'at most 3',
    '1000 nodes / bare work, XML': 'at most 12',
    '1000 nodes / bare work, YAML': 'at most 1',
    '50 nested includes (ms)': 'under 20',
    '50 nested includes, unchanged files (ms)': 'under 20',
    'turtles (ms)': 'under 80',
    'frames (ms)': 'under 80',
    'tf_tree (ms)': 'under 80',
    'graph (ms)': 'under 80',
    'replay of 60 s (ms)': 'under 300',
    '60 s of the large project (ms)': 'under 50',
    'judging / running': 'under 0.1',
}
PARTS = {
    'large project, 20 s': 'large_project',
    'start-up': 'start_up',
    'messages, services, nodes': 'messages',
    'tf': 'tf_lookup',
    'launch files': 'launch_files',
    'pictures': 'pictures',
    'advice': 'advice',
}


def figures_of(part: str) -> dict[str, float]:
    """What a module of this folder measures."""
    command = [sys.executable, '-c', f'import json, {part}; print(json.dumps({part}.measure()))']
    done = subprocess.run(command, cwd=Path(__file__).parent, stdout=subprocess.PIPE, text=True, check=True)
    figures: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return figures


def main() -> None:
    """Print a table."""
    print(f'Python {platform.python_version()} on {platform.machine()}')
    for title, part in PARTS.items():
        print(f'\n{title}', flush=True)
        for name, value in figures_of(part).items():
            print(f'  {name:<48} {value:>10.2f}   {WANTED.get(name, "")}'.rstrip())


if __name__ == '__main__':
    main()

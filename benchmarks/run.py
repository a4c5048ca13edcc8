"""All benchmarks in one run, beside what they should reach:  python benchmarks/run.py"""
from __future__ import annotations

import platform

import large_project
import start_up
import tf_lookup

WANTED = {
    'times real time': 'at least 150',
    'times the bare loop': 'at most 8',
    'import edulaunch (ms)': 'under 30',
    'import launch, launch_ros (ms)': 'under 40',
    'edugrade solutions/circle.launch.py (ms)': 'under 800',
    'latest, 3 frames (us)': 'under 5',
}


def main() -> None:
    """Print a table."""
    print(f'Python {platform.python_version()} on {platform.machine()}')
    for title, part in (('large project, 20 s', large_project), ('start-up', start_up), ('tf', tf_lookup)):
        print(f'\n{title}')
        for name, value in part.measure().items():
            print(f'  {name:<48} {value:>10.2f}   {WANTED.get(name, "")}'.rstrip())


if __name__ == '__main__':
    main()

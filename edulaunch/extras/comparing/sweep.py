"""Compare many launch files in simulation and in reality. Several comparisons run at the same time, each in a separate
process.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import NamedTuple

from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.known import Known

LONGEST_S = 240.0
"""The seconds for a comparison beyond `--for`, more than the busiest computer needs, to find a hanging comparison."""
LAUNCH_ENDINGS = ('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml')


class Row(NamedTuple):
    """The result of comparing one launch file.

    :ivar words: the command-line words, as for `edulaunch compare`.
    :ivar found: the differences that are not known.
    :ivar known: the rows that explain the known differences.
    :ivar problem: the reason why there is no result.
    """

    words: tuple[str, ...]
    found: tuple[Difference, ...] = ()
    known: tuple[Known, ...] = ()
    problem: str = ''

    @property
    def verdict(self) -> str:
        """Return the verdict on this launch file as one or two words."""
        if self.problem:
            return 'not compared'
        return 'differs' if self.found else 'known' if self.known else 'equal'

    @property
    def is_well(self) -> bool:
        """Return whether there is no unknown difference."""
        return not self.problem and not self.found


def launch_files(folder: str) -> Iterator[str]:
    """Return the launch files below a folder, without those in hidden folders and build folders."""
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name[0] not in '._' and name not in ('build', 'install', 'log'))
        yield from (os.path.join(place, name) for name in sorted(names) if name.endswith(LAUNCH_ENDINGS))


def sweep(
    items: Sequence[Sequence[str]],
    seconds: float,
    jobs: int,
    options: Sequence[str] = (),
    folder_of: Callable[[Sequence[str]], str | None] = lambda words: None,
    progress: Callable[[Row], object] = lambda row: None,
) -> list[Row]:
    """Compare each item, `jobs` at a time. Return the rows in the order of the items.

    :param items: the words of each comparison: a path, or a package and a file, and launch arguments.
    :param options: further options of each comparison.
    :param folder_of: returns the folder in which a file is launched; by default, the current folder.
    :param progress: called with each finished row.
    :raises KeyboardInterrupt: after Ctrl-C, when the running comparisons have ended.
    """
    rows: dict[int, Row] = {}
    running: list[subprocess.Popen[str]] = []
    with ThreadPoolExecutor(jobs) as pool:
        futures = {
            pool.submit(_row, tuple(words), seconds, options, folder_of(words), running): number
            for number, words in enumerate(items)
        }
        try:
            for future in as_completed(futures):
                rows[futures[future]] = future.result()
                progress(future.result())
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            for child in list(running):
                child.terminate()
            raise
    return [rows[number] for number in sorted(rows)]


def _row(
    words: tuple[str, ...], seconds: float, options: Sequence[str], folder: str | None, running: list[subprocess.Popen[str]]
) -> Row:
    command = [sys.executable, '-m', 'edulaunch', 'compare', *words, '--for', str(seconds), '--json', *options]
    with subprocess.Popen(
        command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors='replace'
    ) as child:
        running.append(child)
        try:
            output, complaint = child.communicate(timeout=seconds + LONGEST_S)
        except subprocess.TimeoutExpired:
            child.kill()  # this also ends the programs that it has started
            return Row(words, problem=f'it took more than {seconds + LONGEST_S:g} s')
        finally:
            running.remove(child)
    if child.returncode not in (0, 1) or not output:
        lines = [line for line in complaint.splitlines() if line.strip()] or ['no result']
        return Row(words, problem=next((line for line in lines if 'error: ' in line), lines[-1]))
    rows = json.loads(output)
    return Row(words, tuple(Difference(**each) for each in rows['differences']), tuple(Known(**each) for each in rows['known']))


def gone(known: Sequence[Known], rows: Sequence[Row]) -> list[Known]:
    """Return the known differences of these launch files that did not occur, except differences that depend on chance."""
    compared = [row for row in rows if not row.problem]
    return [
        each
        for each in known
        if not each.sometimes
        and any(each.is_about(row.words) for row in compared)
        and not any(each in row.known for row in compared)
    ]

"""A class is graded by a real cluster of worker processes; one of them is killed, and nobody's mark is lost or changed."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.batch.dask_cluster import parcel
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.store import Store
from edugrade.classes.batch.work import Options
from edugrade.cli import main
from edugrade.grading import plan_work
from edugrade.submission import Submission
from edugrade.variant import Variant

pytest.importorskip('distributed', reason='the extra "dask"')
pytestmark = [
    pytest.mark.processes,
    pytest.mark.filterwarnings('ignore::DeprecationWarning'),
    pytest.mark.filterwarnings('ignore::ResourceWarning'),
    pytest.mark.filterwarnings('ignore::pytest.PytestUnraisableExceptionWarning'),
]
SOLUTION = Path(__file__).parents[4] / 'solutions' / 'static_frame.launch.py'
CLUSTER = """
import os, sys
from distributed import Client, LocalCluster
if __name__ == '__main__':
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, host='127.0.0.1') as cluster:
        with Client(cluster) as client:
            print(cluster.scheduler_address, *client.run(os.getpid).values(), flush=True)
        sys.stdin.read()
"""
STUDENTS = ('anna', 'bert', 'carl', 'dora', 'eve')


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[int]]]:
    """The address of a scheduler, and the pids of its two workers."""
    (tmp_path / 'cluster.py').write_text(CLUSTER)
    environment = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path), 'DASK_TEMPORARY_DIRECTORY': str(tmp_path)}
    command = [sys.executable, str(tmp_path / 'cluster.py')]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment, cwd=tmp_path)
    with process:
        assert process.stdout is not None
        address, *pids = process.stdout.readline().split()
        yield address, [int(pid) for pid in pids]
        process.communicate('')


@pytest.fixture
def group(tmp_path: Path) -> Path:
    folder = tmp_path / 'class'
    for name in STUDENTS:
        (folder / name).mkdir(parents=True)
        (folder / name / SOLUTION.name).write_text(f'{SOLUTION.read_text()}# {name}\n')
    (folder / 'eve' / SOLUTION.name).write_text('import posix\nposix.kill(posix.getppid(), 9)\nposix.kill(posix.getpid(), 9)\n')
    return folder


def marks(folder: Path) -> dict[str, Any]:
    return {name: json.loads((folder / name / f'{SOLUTION.name}.json').read_text()) for name in STUDENTS}


def test_a_worker_that_is_killed_costs_no_mark(
    group: Path, tmp_path: Path, cluster: tuple[str, list[int]], monkeypatch: pytest.MonkeyPatch
) -> None:
    address, pids = cluster
    save, saved = Store.save, []

    def kills_a_worker(self: Store, entry: Entry, content: dict[str, Any]) -> None:
        save(self, entry, content)
        if not saved:
            os.kill(pids[0], signal.SIGKILL)
        saved.append(entry.student)

    monkeypatch.setattr(Store, 'save', kills_a_worker)
    words = ['batch', str(group), '--html', str(tmp_path / 'pages')]
    assert main([*words, '--dask', address, '--out', str(tmp_path / 'there')]) == 0
    assert sorted(saved) == sorted(STUDENTS)
    assert (tmp_path / 'pages' / 'anna' / f'{SOLUTION.name}.html').exists()
    monkeypatch.setattr(Store, 'save', save)
    assert main(['batch', str(group), '--out', str(tmp_path / 'here')]) == 0
    assert marks(tmp_path / 'there') == marks(tmp_path / 'here')
    assert [found['points']['earned'] for found in marks(tmp_path / 'here').values()] == [12, 12, 12, 12, 0]


def test_nobody_at_the_address_is_said(group: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['batch', str(group), '--dask', 'tcp://127.0.0.1:1']) == 2
    assert 'no Dask scheduler answers at tcp://127.0.0.1:1' in capsys.readouterr().err


def test_a_parcel_has_the_variant_and_the_other_packages(tmp_path: Path) -> None:
    for name in ('robot', 'more'):
        (tmp_path / 'anna' / name / 'launch').mkdir(parents=True)
        (tmp_path / 'anna' / name / 'package.xml').write_text(f'<package><name>{name}</name></package>')
    launch = tmp_path / 'anna' / 'robot' / 'launch' / 'robot.launch.py'
    launch.write_text('')
    (tmp_path / 'robot.py').write_text(RUBRIC)
    variant = Variant('anna', '01234567', {'0.4': '0.3'})
    submission = Submission(str(launch.parents[1]), str(tmp_path / 'anna'))
    found = parcel(plan_work(submission, str(tmp_path / 'robot.py'), variant=variant), Options())
    assert found['variant'] == {'student': 'anna', 'tag': '01234567', 'values': {'0.4': '0.3'}}
    assert 'more/package.xml' in found['workspaces'][0]
    assert b'0.3' in found['rubric'][1] and b'0.4' not in found['rubric'][1]


RUBRIC = """
from edugrade import Evidence, Rubric, Scenario, check

@check(points=4)
def a(run: Evidence) -> None:
    'The first 0.4'

RUBRIC = Rubric(title='Two', scenarios=lambda random: [Scenario('one', {}, 1.0)], checks=[a])
"""

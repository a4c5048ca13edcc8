"""Many comparisons; those with the real rclpy are in test_for_real.py."""

from __future__ import annotations

import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.extras.comparing import sweep as sweep_room
from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.known import Known
from edulaunch.extras.comparing.sweep import Row, launch_files, sweep
from edulaunch.extras.comparing.verb import table
from tests.extras.comparing.sweep import both


def test_launch_files_of_a_folder(tmp_path: Path) -> None:
    names = [
        'b/x.launch.py',
        'a/y_launch.xml',
        'a/z.py',
        'a/z.launch.yaml',
        'build/q.launch.py',
        '.git/q.launch.py',
        'install/q.launch.py',
    ]
    for name in names:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text('')
    found = [str(Path(path).relative_to(tmp_path)) for path in launch_files(str(tmp_path))]
    assert found == ['a/y_launch.xml', 'a/z.launch.yaml', 'b/x.launch.py']


@pytest.mark.processes
def test_a_comparison_that_cannot_be_made_says_why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('EDULAUNCH_REAL_RCLPY', str(tmp_path / 'none'))
    told: list[Row] = []
    rows = sweep([('turtlesim', 'multisim.launch.py'), ('x.launch.py', '--for', 'ever')], 1.0, 2, progress=told.append)
    assert [row.words[0] for row in rows] == ['turtlesim', 'x.launch.py']
    assert sorted(told) == sorted(rows)
    assert rows[0].problem == 'error: the real rclpy is not installed.'
    assert 'ever' in rows[1].problem
    assert {row.verdict for row in rows} == {'not compared'}
    assert not any(row.is_well for row in rows)


def test_the_table_names_all_that_is_not_equal() -> None:
    known = Known('*', 'one type only')
    rows = [
        Row(('a.launch.py',)),
        Row(('b.launch.py', 'n:=1'), (Difference('node', '/n', 'there', 'missing'),)),
        Row(('c.launch.py',), (), (known,)),
        Row(('d.launch.py',), problem='it took more than 100 s'),
    ]
    text = table(rows)
    assert [line.split()[0] for line in text.splitlines()] == ['launch', 'b.launch.py', 'c.launch.py', 'd.launch.py', 'of']
    assert text.splitlines()[-1] == 'of 4: 1 differs, 1 equal, 1 known, 1 not compared'
    assert 'one type only' in text and 'took more than 100 s' in text


def test_what_differs_once_is_chance_in_the_sweep_of_the_tests() -> None:
    late, lost = Difference('exit code', 'talker', '0', '-9'), Difference('output', 'talker', 'missing', 'lost sys.stderr')
    other = Difference('node', '/talker', 'there', 'missing')
    first, second = Row(('a.launch.py',), (late, lost)), Row(('a.launch.py',), (lost, other))
    assert both(first, second).found == (lost,) and both(second, Row(('a.launch.py',))).is_well
    stuck = Row(('a.launch.py',), problem='not in time')
    assert both(stuck, first) == first == both(first, stuck) and not both(stuck, stuck).is_well


def test_ctrl_c_ends_a_sweep(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[str] = []
    at_work, stopped = threading.Event(), threading.Event()

    def row(words: tuple[str, ...], seconds: float, options: object, folder: object, running: list[Any]) -> Row:
        begun.append(words[0])
        if len(begun) > 1:
            running.append(SimpleNamespace(terminate=stopped.set))
            at_work.set()
            stopped.wait()
        return Row(words)

    def stop(row: Row) -> None:
        at_work.wait()
        raise KeyboardInterrupt

    monkeypatch.setattr(sweep_room, '_row', row)
    with pytest.raises(KeyboardInterrupt):
        sweep([('a',), ('b',), ('c',)], 1.0, 1, progress=stop)
    assert begun == ['a', 'b']

"""The command over the results of a class."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from edugrade.cli import main

ROOT = Path(__file__).parents[3]


@pytest.fixture
def results(tmp_path: Path) -> Path:
    text = (ROOT / 'solutions' / 'static_frame.launch.py').read_text()
    own = '\n\ndef mine(a, b):\n    return [a[index] * b ** 2 for index in range(len(b)) if a[index] > 3 and not b.get(index)]\n'
    for name, add in {'anna': own, 'bert': own.replace('index', 'i'), 'carl': ''}.items():
        (tmp_path / 'class' / name).mkdir(parents=True)
        (tmp_path / 'class' / name / 'static_frame.launch.py').write_text(text + add)
    (tmp_path / 'class' / 'dora').mkdir()
    shutil.make_archive(str(tmp_path / 'class' / 'dora' / 'work'), 'zip', tmp_path / 'class' / 'anna')
    main(['batch', str(tmp_path / 'class')])
    return tmp_path / 'class.results'


def test_pairs_are_named_and_shown(
    results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    capsys.readouterr()
    monkeypatch.chdir(ROOT)
    assert main(['similar', str(results), '--html', str(tmp_path / 'out.html'), '--least', '90']) == 0
    out = capsys.readouterr().out
    assert 'static_frame: 4 submissions, 3 pairs with at least 90% of their code in common' in out or '6 pairs' in out, out
    assert 'anna/static_frame.launch.py  bert/static_frame.launch.py' in out
    assert 'dora/work.zip/static_frame.launch.py' in out
    assert 'anna and bert' in (tmp_path / 'out.html').read_text()


def test_the_launch_graph_has_no_names_in_it(results: Path) -> None:
    found = json.loads((results / 'anna' / 'static_frame.launch.py.json').read_text())
    assert found['graph'].count('starts tf2_ros/static_transform_publisher') == 2
    assert 'laser' not in str(found['graph'])


def test_what_is_gone_is_said(results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'class' / 'carl' / 'static_frame.launch.py').write_text('changed')
    assert main(['similar', str(results)]) == 0
    assert 'not found with the text that was graded: carl/static_frame.launch.py' in capsys.readouterr().out
    assert main(['similar', str(results), '--exercise', 'circle']) == 2
    assert main(['similar', str(tmp_path)]) == 0

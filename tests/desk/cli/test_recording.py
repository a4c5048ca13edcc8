"""`edulaunch recording info`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp('rec') / 'multisim.rec'
    assert main(['launch', 'turtlesim', 'multisim.launch.py', '--fast', '--for', '1', '--record', str(path)]) == 0
    return path


def test_it_says_what_a_recording_holds(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'info', str(file)]) == 0
    out = capsys.readouterr().out
    assert 'Duration:     1.0' in out
    assert '  /turtlesim1/turtlesim (turtlesim_node-1)\n  /turtlesim2/turtlesim (turtlesim_node-2)\n' in out
    assert '/turtlesim1/turtle1/pose' in out and 'turtlesim/msg/Pose' in out


def test_as_json_it_can_be_read_by_programs(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'info', str(file), '--json']) == 0
    summary = json.loads(capsys.readouterr().out)
    topics = {topic['name']: topic for topic in summary['topics']}
    assert topics['/turtlesim1/turtle1/pose']['messages'] == 61
    assert len(summary['digest']) == 64 and summary['seed'] == 0


def test_what_is_no_recording_gets_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'x').write_text('hello')
    assert main(['recording', 'info', str(tmp_path / 'x')]) == 2
    assert main(['recording', 'info', str(tmp_path / 'y')]) == 2
    err = capsys.readouterr().err
    assert 'is damaged: line 1 is not JSON' in err and 'cannot read the recording' in err and 'Traceback' not in err


def test_two_recordings_are_compared(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other, picture = str(tmp_path / 'other.rec'), str(tmp_path / 'two.png')
    assert main(['launch', 'turtlesim', 'multisim.launch.py', '--fast', '--for', '2', '--record', other]) == 0
    capsys.readouterr()
    assert main(['recording', 'diff', str(file), str(file)]) == 0
    assert capsys.readouterr().out == 'no difference\n'
    assert main(['recording', 'diff', str(file), other, '--png', picture]) == 1
    out = capsys.readouterr().out
    assert '~ messages on /turtlesim1/turtle1/pose: 124, before 61\n' in out and out.endswith(f'{picture}\n')
    assert Path(picture).read_bytes().startswith(b'\x89PNG')
    page = tmp_path / 'two.html'
    assert main(['recording', 'diff', str(file), other, '--html', str(page)]) == 1
    assert '<td>messages on /turtlesim1/turtle1/pose: 124, before 61</td>' in page.read_text(encoding='utf-8')
    assert main(['recording', 'diff', str(file), other, '--png', str(tmp_path / 'no' / 'x.png')]) == 2


def test_a_page_opens_at_the_tab_launch(file: Path, tmp_path: Path) -> None:
    page = tmp_path / 'run.html'
    assert main(['recording', 'show', str(file), '--tab', 'launch', '--html', str(page)]) == 0
    assert '"tab": "launch"' in page.read_text(encoding='utf-8')


def test_a_page_is_not_written_where_only_a_picture_is_asked_for(file: Path, tmp_path: Path) -> None:
    picture = tmp_path / 'run.png'
    assert main(['recording', 'show', str(file), '--png', str(picture)]) == 0
    assert picture.is_file() and not file.with_suffix('.html').exists()


def test_an_export_does_not_write_over_a_folder(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / 'tables'
    assert main(['recording', 'export', str(file), '--csv', str(folder)]) == 0
    assert list(folder.glob('*.csv'))
    assert main(['recording', 'export', str(file), '--csv', str(folder)]) == 2
    assert f'{folder} already exists' in capsys.readouterr().err

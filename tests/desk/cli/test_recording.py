"""`edulaunch recording info`."""

from __future__ import annotations

import json
import webbrowser
from pathlib import Path

import pytest
from rosidl_runtime_py.utilities import get_message

from edulaunch.desk.cli.main import main
from edulaunch.desk.cli.recording import _cells, lines, summarise
from edulaunch.engine.recording import Recording


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
    assert 'x is not a recording of edulaunch' in err and 'cannot read the recording' in err and 'Traceback' not in err


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


SUMMARY = {
    'launch_file': '/home/ada/a.launch.py',
    'arguments': {'x': '1', 'y': 'two'},
    'seed': 7,
    'duration_s': 1.25,
    'digest': 'abc',
    'log_messages': 3,
    'processes': [
        {'name': 'sim-1', 'pid': 1002, 'origin': ('a.launch.py', 4), 'started_s': 0.0, 'ended_s': None, 'returncode': None},
        {'name': 'drive-2', 'pid': 1003, 'origin': None, 'started_s': 0.0, 'ended_s': 0.5, 'returncode': -2},
    ],
    'nodes': [{'name': '/sim', 'process': 'sim-1'}],
    'topics': [
        {'name': '/a', 'type': 'std_msgs/msg/String', 'messages': 12},
        {'name': '/longer', 'type': 'std_msgs/msg/Bool', 'messages': 0},
    ],
    'not_repeatable': ['it reads the clock'],
    'warnings': ['nobody listens'],
}


def test_the_summary_for_people() -> None:
    assert lines(SUMMARY) == [
        'Launch file:  /home/ada/a.launch.py x:=1 y:=two',
        'Duration:     1.250 s (seed 7)',
        'Digest:       abc',
        'Log messages: 3',
        'Not repeatable: it reads the clock',
        '',
        'Processes:',
        '  sim-1 (pid 1002): running at the end  [a.launch.py:4]',
        '  drive-2 (pid 1003): ended at 0.500 s with code -2',
        '',
        'Nodes:',
        '  /sim (sim-1)',
        '',
        'Topics:',
        '  /a            12 messages  std_msgs/msg/String',
        '  /longer        0 messages  std_msgs/msg/Bool',
        '',
        'warning: nobody listens',
    ]
    assert lines({**SUMMARY, 'arguments': {}, 'topics': [], 'warnings': []})[-2:] == ['', 'Topics:']


def test_the_summary_of_a_run_has_its_processes_and_topics(file: Path) -> None:
    summary = summarise(Recording.load(str(file)))
    assert list(summary) == [
        *('launch_file', 'arguments', 'seed', 'duration_s', 'digest', 'processes', 'nodes', 'topics'),
        *('log_messages', 'not_repeatable', 'warnings'),
    ]
    assert [(row['name'], row['pid'], row['returncode'], row['started_s']) for row in summary['processes']] == [
        ('launch', 1001, 0, 0.0),
        ('turtlesim_node-1', 1002, 0, 0.0),
        ('turtlesim_node-2', 1003, 0, 0.0),
    ]
    pose = next(topic for topic in summary['topics'] if topic['name'] == '/turtlesim2/turtle1/pose')
    assert pose == {
        'name': '/turtlesim2/turtle1/pose',
        'type': 'turtlesim/msg/Pose',
        'messages': 61,
        'publishers': ['/turtlesim2/turtlesim'],
        'subscriptions': [],
    }


def test_tables_have_a_row_for_each_message_and_a_column_for_each_number(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / 'tables'
    assert main(['recording', 'export', str(file), '--csv', str(folder), '--topics', '/turtlesim1/turtle1/pose']) == 0
    assert capsys.readouterr().out == f'{folder}\n'
    (table,) = folder.iterdir()
    rows = table.read_text().splitlines()
    assert (table.name, len(rows)) == ('turtlesim1.turtle1.pose.csv', 62)
    assert rows[:2] == [
        'time,x,y,theta,linear_velocity,angular_velocity',
        '0.032000000,5.544444561004639,5.544444561004639,0.0,0.0,0.0',
    ]


def test_a_table_of_lists_has_a_column_for_each_element() -> None:
    message = get_message('tf2_msgs/msg/TFMessage')()
    message.transforms = [get_message('geometry_msgs/msg/TransformStamped')(child_frame_id='a')]
    cells = dict(_cells(message))
    assert (cells['transforms.0.child_frame_id'], cells['transforms.0.transform.rotation.w']) == ('a', 1.0)
    assert dict(_cells(get_message('std_msgs/msg/UInt8MultiArray')(data=b'\1\2'))) == {
        'layout.data_offset': 0,
        'data.0': 1,
        'data.1': 2,
    }


@pytest.mark.parametrize(
    ('words', 'ending'),
    [(['--csv'], '_csv'), (['--mcap'], '.mcap'), (['--bag'], '_bag'), (['--bag', '--storage', 'sqlite3'], '_bag')],
)
def test_an_export_stands_beside_the_recording(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], words: list[str], ending: str
) -> None:
    mine = tmp_path / 'mine.rec'
    mine.write_bytes(file.read_bytes())
    assert main(['recording', 'export', str(mine), *words]) == 0
    assert capsys.readouterr().out == f'{tmp_path}/mine{ending}\n'
    made = tmp_path / f'mine{ending}'
    if ending == '_bag':
        endings = {path.suffix for path in made.iterdir()}
        assert endings == ({'.yaml', '.db3'} if 'sqlite3' in words else {'.yaml', '.mcap'})
    elif ending == '.mcap':
        assert made.read_bytes().startswith(b'\x89MCAP')
        assert sorted(path.name for path in tmp_path.iterdir()) == ['mine.mcap', 'mine.rec']


def test_a_topic_without_messages_is_not_exported(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'export', str(file), '--csv', str(tmp_path / 'a'), '--topics', '/no']) == 2
    assert capsys.readouterr().err.startswith('error: nothing was published on /no\n  help: choose topics with messages: /')
    (tmp_path / 'a').write_text('')
    assert main(['recording', 'export', str(file), '--csv', str(tmp_path / 'a' / 'b')]) == 2
    assert capsys.readouterr().err == f'error: cannot write {tmp_path}/a/b: Not a directory\n'


@pytest.mark.parametrize('what', ['turtles', 'tree', 'graph', None])
def test_a_picture_of_each_kind(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], what: str | None) -> None:
    mine = tmp_path / 'mine.rec'
    mine.write_bytes(file.read_bytes())
    code = main(['recording', 'show', str(mine), '--png', *(['--what', what] if what else []), '--at', '0.5'])
    shown = capsys.readouterr()
    assert (code, shown.out) == ((1, '') if what == 'tree' else (0, f'{tmp_path}/mine.png\n')), shown.err


def test_a_page_stands_beside_the_recording_and_opens(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    mine, opened = tmp_path / 'mine.rec', []
    mine.write_bytes(file.read_bytes())
    monkeypatch.setattr(webbrowser, 'open', opened.append)
    assert main(['recording', 'show', str(mine), '--with', str(file)]) == 0
    assert (capsys.readouterr().out, opened) == (f'{tmp_path}/mine.html\n', [])
    page = (tmp_path / 'mine.html').read_text(encoding='utf-8')
    assert '"tab": "graph"' in page and 'multisim.launch.py' in page
    assert (
        main(['recording', 'show', str(mine), '--html', str(tmp_path / 'b.html'), '--png', str(tmp_path / 'b.png'), '--open'])
        == 0
    )
    assert capsys.readouterr().out == f'{tmp_path}/b.html\n{tmp_path}/b.png\n'
    assert opened == [f'file://{tmp_path}/b.html']
    assert main(['recording', 'show', str(mine), '--html', str(tmp_path / 'no' / 'x.html')]) == 2
    assert capsys.readouterr().err == f'error: cannot write {tmp_path}/no/x.html: No such file or directory\n'

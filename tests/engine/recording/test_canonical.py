"""A digest is the same wherever things lie."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.recording.canonical import canonical

ROOTS = [
    ['/tmp', '@tmp'],
    ['/home/me', '@home'],
    ['/home/me/ws', '@cwd'],
    ['/usr/lib/python3.11', '@stdlib'],
    ['/', '@x'],
    ['', '@y'],
]
EMPTY: dict[str, Any] = {
    **dict.fromkeys(('processes', 'logs', 'notes', 'parameters', 'calls', 'output', 'topics'), []),
    'launch': {},
    'roots': ROOTS,
}


@pytest.mark.parametrize(
    'text, short',
    [
        ('/tmp/tmpabc', '@tmp/tmpabc'),
        ('/tmpabc /tmp.old /tmp-1 /tmp', '/tmpabc /tmp.old /tmp-1 @tmp'),
        ('in /tmp. (/tmp) "/tmp/a" a=/tmp:/tmp', 'in @tmp. (@tmp) "@tmp/a" a=@tmp:@tmp'),
        ('/home/tmp/x /home/me/ws/tmp /home/me/wsx', '/home/tmp/x @cwd/tmp @home/wsx'),
        ('file:///tmp/x \x1b[31m/tmp/y\x1b[0m a\\n/tmp', 'file://@tmp/x \x1b[31m@tmp/y\x1b[0m a\\n@tmp'),
        ('a/tmp ~/tmp ./tmp no path', 'a/tmp ~/tmp ./tmp no path'),
    ],
)
def test_a_root_counts_where_a_path_begins_with_it(text: str, short: str) -> None:
    assert canonical({**EMPTY, 'notes': [[0, None, 'kind', text]]})['notes'] == [[0, None, 'kind', short]]


def test_calls_and_messages_of_any_type_may_name_files() -> None:
    topic = {'type': 'mine/msg/Where', 'messages': [[1, ['/tmp/a', []]]]}
    content = {**EMPTY, 'calls': [[0, ['/tmp/b']]], 'topics': [topic], 'launch': {'arguments': {'map': '/tmp/c'}, 'count': 2}}
    short = canonical(content)
    assert short['launch'] == {'arguments': {'map': '@tmp/c'}, 'count': 2}
    assert short['calls'] == [[0, ['@tmp/b']]] and short['topics'][0]['messages'] == [[1, ['@tmp/a', []]]]


@pytest.mark.parametrize('part', ['facts', 'descriptors', 'beside', 'processes', 'logs', 'output'])
def test_every_other_part_may_name_files(part: str) -> None:
    rows: Any = {'x': '/tmp/a'} if part == 'beside' else [[0, 'x', 'stdout', '/tmp/a']]
    short = canonical({**EMPTY, part: rows})
    assert short[part] == ({'x': '@tmp/a'} if part == 'beside' else [[0, 'x', 'stdout', '@tmp/a']]) and short['roots'] == []


@pytest.mark.parametrize('package', ['tf2_msgs', 'geometry_msgs', 'sensor_msgs', 'nav_msgs'])
def test_names_of_frames_are_no_files(package: str) -> None:
    topic = {'type': f'{package}/msg/Any', 'messages': [[1, ['/tmp']]]}
    assert canonical({**EMPTY, 'topics': [topic]})['topics'] == [topic]


DIED = """Traceback (most recent call last):
  File "/home/me/ws/x.py", line 3, in go
    json.loads(text)
  File "/usr/lib/python3.11/json/__init__.py", line 346, in loads
    return _default_decoder.decode(s)
           ^^^^^^^^^^^^^^^^^^^^^^^^^^
ValueError: no
"""
KEPT = """Traceback (most recent call last):
  File "@cwd/x.py", line 3, in go
    json.loads(text)
ValueError: no
"""


def test_frames_of_libraries_do_not_count() -> None:
    """Neither in one piece nor as launch prints them, with another program's lines between them."""
    rows = [[0, 'x-1', 'stderr', DIED]]
    rows += [[0, 'launch', 'stdout', f'[x-1] {line}'] for line in DIED.splitlines(keepends=True)]
    rows.insert(5, [0, 'other-2', 'stdout', '    indented\n'])
    kept = [[0, 'x-1', 'stderr', KEPT]]
    kept += [[0, 'launch', 'stdout', f'[x-1] {line}'] for line in KEPT.splitlines(keepends=True)]
    found = canonical({**EMPTY, 'output': rows})['output']
    assert [row for row in found if row[1] != 'other-2'] == kept and [0, 'other-2', 'stdout', '    indented\n'] in found


LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {script!r}], output='screen')])
"""
TELLS = """import json, os, sys, tempfile
print(os.getcwd(), __file__, os.path.realpath(__file__), os.path.expanduser('~'), sys.executable, sys.prefix, json.__file__)
print(tempfile.gettempdir(), os.environ['HOME'])
with tempfile.TemporaryDirectory() as place:
    print(place, tempfile.mktemp())
json.loads('{')
"""


def test_a_program_that_prints_its_folders_has_the_same_digest_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    digests = set()
    for number, name in enumerate(('here', 'some/where/else')):
        folder = tmp_path / f'real-{number}' / name
        for part in ('launch', 'home', 'work', 'tmp'):
            (folder / part).mkdir(parents=True)
        (tmp_path / f'link-{number}').symlink_to(folder)
        monkeypatch.chdir(folder / 'work')
        monkeypatch.setenv('HOME', str(folder / 'home'))
        monkeypatch.setattr('tempfile.tempdir', str(folder / 'tmp'))
        monkeypatch.setenv('TMPDIR', str(folder / 'tmp'))
        script = os.path.join(tmp_path, f'link-{number}', 'launch', 'tells.py')
        Path(script).write_text(TELLS)
        file = Path(script).with_name('tells.launch.py')
        file.write_text(LAUNCH.format(script=script))
        recording = edulaunch.run(file, duration_s=1.0)
        digests.add(recording.digest())
    assert len(digests) == 1, recording.output


ELSEWHERE = """import sys
sys.path.insert(0, sys.argv[1])
import edulaunch
recording = edulaunch.run(sys.argv[2], duration_s=3.0)
print(edulaunch.__file__, 'bag_record.py' in str(recording.messages('/rosout')), recording.digest())
"""
RECORDS = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', 'drive', '/pose'], output='screen')])
"""


@pytest.mark.processes
def test_a_line_that_names_a_file_of_ours_has_the_same_digest_wherever_edulaunch_lies(tmp_path: Path) -> None:
    """`ros2 bag record` logs with its own file and line."""
    house = Path(edulaunch.__file__).resolve().parent
    (tmp_path / 'copied').mkdir()
    shutil.copytree(house, tmp_path / 'copied' / 'edulaunch', ignore=shutil.ignore_patterns('__pycache__'))
    file = tmp_path / 'records.launch.py'
    file.write_text(RECORDS)
    found = set()
    for place in (house.parent, tmp_path / 'copied'):
        shutil.rmtree(tmp_path / 'drive', ignore_errors=True)
        command = [sys.executable, '-c', ELSEWHERE, str(place), str(file)]
        env = {
            name: value for name, value in os.environ.items() if name not in ('PYTHONPATH', 'AMENT_PREFIX_PATH')
        }  # an activated shell
        done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=True)
        imported, logged, digest = done.stdout.split()
        assert Path(imported).parent.parent == place and logged == 'True'
        found.add(digest)
    assert len(found) == 1

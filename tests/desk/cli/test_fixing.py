"""`edulaunch doctor --fix`: shows the difference, asks, changes only what was named, and each file whole or not at all."""

from __future__ import annotations

import errno
import io
import json
import os
from pathlib import Path

import pytest

from edulaunch.desk.cli import fixing
from edulaunch.desk.cli.main import main

BAD = """from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesm', executable='turtlesim_node', outputt='screen')
        LogInfo(mgs='started'),
        TimerAction(period=1.0, actions=[LogInfo(msg='later')]),
    ])
"""
GOOD = """from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node
from launch.actions import TimerAction


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', output='screen'),
        LogInfo(msg='started'),
        TimerAction(period=1.0, actions=[LogInfo(msg='later')]),
    ])
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / 'a.launch.py'
    path.write_text(BAD, encoding='utf-8')
    path.chmod(0o750)
    return path


def typed(monkeypatch: pytest.MonkeyPatch, answer: str) -> None:
    stdin = io.StringIO(answer)
    stdin.isatty = lambda: True  # type: ignore[method-assign]
    monkeypatch.setattr('sys.stdin', stdin)


def test_five_mistakes_are_mended_after_a_yes(
    file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    typed(monkeypatch, 'y\n')
    assert main(['doctor', '--fix', 'a.launch.py']) == 0
    shown = capsys.readouterr().out
    assert (
        '--- a.launch.py\n+++ a.launch.py\n' in shown
        and "-        LogInfo(mgs='started'),\n" in shown
        and "+        LogInfo(msg='started'),\n" in shown
    )
    assert shown.endswith('changed a.launch.py\n')
    assert (file.read_text(encoding='utf-8'), file.stat().st_mode & 0o777) == (GOOD, 0o750)
    assert main(['doctor', 'a.launch.py', '--for', '2']) == 0


@pytest.mark.parametrize('answer', ['n\n', '\n'])
def test_any_other_answer_changes_nothing(file: Path, monkeypatch: pytest.MonkeyPatch, answer: str) -> None:
    typed(monkeypatch, answer)
    assert main(['doctor', '--fix', 'a.launch.py']) == 1
    assert file.read_text(encoding='utf-8') == BAD


def test_a_script_says_yes_beforehand(file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('sys.stdin', io.StringIO(''))
    assert main(['doctor', '--fix', 'a.launch.py']) == 1
    assert capsys.readouterr().out.endswith('add --yes to make these changes\nnothing was changed\n') and file.read_text() == BAD
    assert main(['doctor', '--fix', '--yes', 'a.launch.py']) == 0
    assert file.read_text(encoding='utf-8') == GOOD
    assert main(['doctor', '--fix', '--yes', 'a.launch.py', '--for', '1']) == 1
    assert capsys.readouterr().out.endswith('nothing was changed\n')


def test_only_what_was_named_is_changed(file: Path, tmp_path: Path) -> None:
    inner, outside = tmp_path / 'inner', tmp_path / 'outside.launch.py'
    inner.mkdir()
    outside.write_text(BAD, encoding='utf-8')
    (inner / 'b.launch.py').write_text(BAD, encoding='utf-8')
    (inner / 'link.launch.py').symlink_to(outside)
    assert main(['doctor', '--fix', '--yes', 'inner']) == 0
    assert [path.read_text(encoding='utf-8') for path in (inner / 'b.launch.py', file, outside)] == [GOOD, BAD, BAD]
    assert (inner / 'link.launch.py').is_symlink()


def test_a_built_in_launch_file_is_not_changed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor', '--fix', '--yes', 'turtlesim', 'multisim.launch.py', '--for', '1']) == 2
    assert 'belongs to edulaunch' in capsys.readouterr().err


@pytest.mark.parametrize('call', ['fsync', 'replace'])
def test_a_fault_in_the_middle_loses_nothing(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, call: str
) -> None:
    for name in ('b', 'c'):
        (tmp_path / f'{name}.launch.py').write_text(BAD, encoding='utf-8')
    real, count = getattr(os, call), 0

    def fail_the_second_time(*arguments: object) -> object:
        nonlocal count
        count += not isinstance(arguments[0], int) or os.path.isfile(f'/proc/self/fd/{arguments[0]}')
        if count == 2:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return real(*arguments)

    monkeypatch.setattr(os, call, fail_the_second_time)
    changes = fixing.changes_for('.', [])
    assert [os.path.basename(change.path) for change in changes] == ['a.launch.py', 'b.launch.py', 'c.launch.py']
    assert fixing.fix(changes, True) == 1
    assert (
        'b.launch.py could not be changed: No space left on device\n  help: 1 files are changed, 1 are not'
        in capsys.readouterr().err
    )
    assert [(tmp_path / f'{name}.launch.py').read_text(encoding='utf-8') for name in 'abc'] == [GOOD, BAD, BAD]
    assert sorted(path.name for path in tmp_path.iterdir()) == ['a.launch.py', 'b.launch.py', 'c.launch.py']


def test_what_another_program_has_written_meanwhile_stays(file: Path) -> None:
    changes = fixing.changes_for('a.launch.py', [])
    file.write_text('mine', encoding='utf-8')
    assert fixing.fix(changes, True) == 1
    assert file.read_text(encoding='utf-8') == 'mine'


def test_line_ends_of_windows_stay(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'w.launch.py').write_bytes(BAD.replace('\n', '\r\n').encode())
    (change,) = fixing.changes_for('w.launch.py', [])
    assert change.after.replace(b'\r\n', b'\n').decode() == GOOD and change.after.count(b'\r\n') >= GOOD.count('\n') - 1


def test_a_finding_of_a_package_is_mended_in_its_build_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert (
        main(['pkg', 'create', '--build-type', 'ament_python', 'patrol', '--license', 'MIT', '--dependencies', 'ros2launch']) == 0
    )
    (tmp_path / 'patrol/launch').mkdir()
    (tmp_path / 'patrol/launch/a.launch.py').write_text(GOOD, encoding='utf-8')
    assert main(['doctor', '--fix', '--yes', 'patrol']) == 0
    text = (tmp_path / 'patrol/setup.py').read_text(encoding='utf-8')
    assert (
        "(os.path.join('share', package_name, 'launch'), glob('launch/*launch.[pxy][yma]*'))" in text
        and 'from glob import glob' in text
    )
    assert main(['doctor', 'patrol', '--for', '2']) == 0


def test_json_has_the_edits_for_editors_and_code_hosts(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file.write_text(BAD.replace("'screen')", "'screen'),").replace("outputt='screen'", ''), encoding='utf-8')
    assert main(['doctor', 'a.launch.py', '--json', 'lsp']) == 1
    ((uri, (first, *_)),) = json.loads(capsys.readouterr().out).items()
    assert (uri, first['code'], first['severity']) == (file.as_uri(), 'launch.missing-keyword', 1)
    assert first['range'] == {'start': {'line': 8, 'character': 16}, 'end': {'line': 8, 'character': 20}}
    assert [change['newText'] for change in first['data']['changes']] == ['msg=']
    assert main(['doctor', 'a.launch.py', '--json', 'sarif']) == 1
    (run,) = json.loads(capsys.readouterr().out)['runs']
    ((replacement,),) = [change['replacements'] for change in run['results'][0]['fixes'][0]['artifactChanges']]
    assert replacement == {
        'deletedRegion': {'startLine': 9, 'startColumn': 17, 'endLine': 9, 'endColumn': 21},
        'insertedContent': {'text': 'msg='},
    }

"""A dry run starts nothing and changes nothing: what a launch file would do at once is noted, and not done."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.advice.plan import rehearse
from edulaunch.desk.cli.main import main
from edulaunch.engine.packages import Index

HEAD = """
import ctypes, io, os, pathlib, shutil, socket, subprocess, tempfile, urllib.request
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import Command

def generate_launch_description():
"""
Plan = Callable[[str], dict[str, Any]]


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    """The plan of a launch file whose function has this body; FOLDER stands for the folder of the test."""

    def make(body: str) -> dict[str, Any]:
        path = tmp_path / 'a.launch.py'
        lines = body.replace('FOLDER', str(tmp_path)).strip().splitlines()
        path.write_text(HEAD + ''.join(f'    {line}\n' for line in lines), encoding='utf-8')
        return rehearse(path, (), Index(), {'HOME': '/h', 'PATH': os.environ['PATH']}).plan

    return make


def logs(plan: dict[str, Any]) -> list[str]:
    return [item['msg'] for item in plan['items'] if item['kind'] == 'log']


STARTS = [
    "subprocess.run(['touch', 'FOLDER/made'])",
    "subprocess.check_output('touch FOLDER/made', shell=True)",
    "subprocess.call(['sh', '-c', 'touch FOLDER/made'])",
    "subprocess.Popen(['touch', 'FOLDER/made']).wait()",
    "os.system('touch FOLDER/made')",
    "os.popen('touch FOLDER/made').read()",
    "Command('touch FOLDER/made').perform(None)",
    "os.spawnlp(os.P_WAIT, 'touch', 'touch', 'FOLDER/made')",
    "os.spawnve(os.P_NOWAIT, '/usr/bin/touch', ['touch', 'FOLDER/made'], {})",
]


@pytest.mark.parametrize('line', STARTS)
def test_a_command_of_this_computer_is_not_run(plan: Plan, tmp_path: Path, line: str) -> None:
    found = plan(f"{line}\nreturn LaunchDescription([LogInfo(msg='on')])")
    assert (found['error'], logs(found)) == (None, ['on'])
    assert not (tmp_path / 'made').exists()
    (note,) = found['not_done']
    assert note.startswith('run the command ') and 'made' in note


def test_a_command_that_is_not_there_fails_as_it_does_at_a_launch(plan: Plan) -> None:
    found = plan("return LaunchDescription([LogInfo(msg=Command('no-such-command'))])")
    assert 'no-such-command' in found['error']['text']
    assert 'not_done' not in found


def test_what_cat_and_echo_print_is_known_without_them(plan: Plan, tmp_path: Path) -> None:
    (tmp_path / 'note.txt').write_text('read\n', encoding='utf-8')
    found = plan("return LaunchDescription([LogInfo(msg=[Command('cat FOLDER/note.txt'), Command('echo a  b')])])")
    assert (logs(found), found.get('not_done')) == (['read\na b\n'], None)
    found = plan("return LaunchDescription([LogInfo(msg=Command('cat FOLDER/none.txt'))])")
    assert 'none.txt: No such file' in found['error']['text']


CHANGES = [
    ("open('FOLDER/kept', 'w').write('new')", 'write '),
    ("open('FOLDER/kept', 'a').write('new')", 'write '),
    ("open('FOLDER/made', 'x').write('new')", 'write '),
    ("io.open('FOLDER/made', 'w').write('new')", 'write '),
    ("pathlib.Path('FOLDER/kept').write_text('new')", 'write '),
    ("os.remove('FOLDER/kept')", 'remove '),
    ("pathlib.Path('FOLDER/kept').unlink()", 'remove '),
    ("shutil.rmtree('FOLDER/full')", 'remove '),
    ("os.rename('FOLDER/kept', 'FOLDER/made')", 'rename '),
    ("os.makedirs('FOLDER/made/deep', exist_ok=True)", 'make the folder '),
    ("os.symlink('FOLDER/kept', 'FOLDER/made')", 'make {}/made'),
    ("os.chmod('FOLDER/kept', 0)", 'change '),
    ("shutil.copy('FOLDER/kept', 'FOLDER/made')", 'write '),
    ("os.replace(tempfile.mkstemp()[1], 'FOLDER/kept')", 'rename '),
    ("shutil.move(tempfile.mkstemp()[1], 'FOLDER/kept')", 'rename '),
]


@pytest.mark.parametrize(('line', 'note'), CHANGES)
def test_a_file_is_not_changed(plan: Plan, tmp_path: Path, line: str, note: str) -> None:
    (tmp_path / 'kept').write_text('old', encoding='utf-8')
    (tmp_path / 'full').mkdir()
    (tmp_path / 'full/inner').write_text('old', encoding='utf-8')
    found = plan(f"{line}\nreturn LaunchDescription([LogInfo(msg='on')])")
    assert (found['error'], logs(found)) == (None, ['on'])
    assert found['not_done'][0].startswith(note.format(tmp_path))
    assert sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob('*')) == [
        'a.launch.py',
        'full',
        'full/inner',
        'kept',
    ]
    assert ((tmp_path / 'kept').read_text(), (tmp_path / 'kept').stat().st_mode & 0o400) == ('old', 0o400)


def test_the_launch_file_reads_what_it_wrote(plan: Plan, tmp_path: Path) -> None:
    found = plan("""
os.makedirs('FOLDER/new', exist_ok=True)
with open('FOLDER/new/a.txt', 'w') as file: file.write('kept apart')
return LaunchDescription([LogInfo(msg=open('FOLDER/new/a.txt').read())])""")
    assert (found['error'], logs(found)) == (None, ['kept apart'])
    assert not (tmp_path / 'new').exists()


def test_a_temporary_file_works_and_is_gone_afterwards(plan: Plan) -> None:
    found = plan("""
with tempfile.NamedTemporaryFile('w', suffix='.yaml', delete=False) as file: file.write('x: 1')
folder = tempfile.mkdtemp()
open(os.path.join(folder, 'b'), 'w').close()
return LaunchDescription([LogInfo(msg=file.name), LogInfo(msg=open(file.name).read()), LogInfo(msg=folder)])""")
    name, text, folder = logs(found)
    assert (text, found.get('not_done')) == ('x: 1', None)
    assert not os.path.exists(name) and not os.path.exists(folder)


@pytest.mark.parametrize('make', ['tempfile.mkdtemp()', "tempfile.NamedTemporaryFile('w', delete=False).name"])
def test_a_temporary_name_that_another_program_has_taken_is_left_alone(plan: Plan, make: str) -> None:
    body = f'return LaunchDescription([LogInfo(msg={make})])'
    (taken,) = logs(plan(body))
    Path(taken).write_text('of another program', encoding='utf-8')
    try:
        (other,) = logs(plan(body))
        assert (other != taken, os.path.exists(taken), os.path.exists(other)) == (True, True, False)
    finally:
        os.remove(taken)


def test_a_folder_that_is_not_there_is_an_error_as_at_a_launch(plan: Plan) -> None:
    found = plan("open('FOLDER/none/a.txt', 'w')\nreturn LaunchDescription([])")
    assert 'No such file or directory' in found['error']['text']


def test_a_library_that_changes_something_is_stopped(plan: Plan, tmp_path: Path) -> None:
    found = plan("import numpy\nnumpy.save('FOLDER/made.npy', numpy.zeros(3))\nreturn LaunchDescription([])")
    assert 'not done in a dry run' in found['error']['text']
    assert found['not_done'] == [f'write {tmp_path}/made.npy']
    assert not (tmp_path / 'made.npy').exists()


OUTSIDE = [
    ("ctypes.CDLL(None).system(b'touch FOLDER/made')", 'call the function system of the C library'),
    ("ctypes.CDLL(None).unlink(b'FOLDER/a.launch.py')", 'call the function unlink of the C library'),
    ("socket.create_connection(('127.0.0.1', PORT), 1)", 'connect to 127.0.0.1:PORT'),
    ("urllib.request.urlopen('http://127.0.0.1:PORT/', b'data', 1)", 'connect to 127.0.0.1:PORT'),
    ("with socket.socket(type=socket.SOCK_DGRAM) as way: way.sendto(b'x', ('127.0.0.1', PORT))", 'connect to 127.0.0.1:PORT'),
]


@pytest.mark.parametrize(('line', 'note'), OUTSIDE)
def test_neither_c_code_nor_a_server_hears_of_a_dry_run(plan: Plan, tmp_path: Path, line: str, note: str) -> None:
    with socket.create_server(('127.0.0.1', 0)) as server:
        server.setblocking(False)
        port = str(server.getsockname()[1])
        found = plan(f'{line}\nreturn LaunchDescription([])'.replace('PORT', port))
        with pytest.raises(BlockingIOError):
            server.accept()
    assert 'not done in a dry run' in found['error']['text'] and found['not_done'] == [note.replace('PORT', port)]
    assert [path.name for path in tmp_path.iterdir()] == ['a.launch.py']


def test_a_program_may_find_the_address_of_this_computer(plan: Plan) -> None:
    found = plan("""
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
    probe.connect(('127.0.0.1', 80))
    own = probe.getsockname()[0]
return LaunchDescription([LogInfo(msg=own), LogInfo(msg=str(ctypes.CDLL(None).abs(-3)))])""")
    assert (found['error'], logs(found), found.get('not_done')) == (None, ['127.0.0.1', '3'], None)


def test_explain_says_what_was_not_done(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'a.launch.py'
    path.write_text(f"{HEAD}    os.system('touch {tmp_path}/made')\n    return LaunchDescription([])\n", encoding='utf-8')
    assert main(['explain', str(path)]) == 0
    assert f'the dry run skipped: run the command touch {tmp_path}/made' in capsys.readouterr().err
    assert not (tmp_path / 'made').exists()


def test_a_link_that_is_made_below_os_is_called_by_its_own_name(plan: Plan, tmp_path: Path) -> None:
    found = plan("import posix\nposix.symlink('/etc/hostname', 'FOLDER/made')\nreturn LaunchDescription([])")
    assert found['not_done'] == [f'make {tmp_path}/made']
    assert not os.path.lexists(tmp_path / 'made')


LATE = """
import weakref
from launch import LaunchDescription


class Part:
    def __del__(self):
        open('FOLDER/by-del', 'w').close()


part, other = Part(), set()
weakref.finalize(other, lambda: open('FOLDER/by-finalize', 'w').close())


def generate_launch_description():
    return LaunchDescription([])
"""


@pytest.mark.processes
def test_what_a_launch_file_writes_at_the_exit_of_python_is_lost_without_a_traceback(tmp_path: Path) -> None:
    path = tmp_path / 'late.launch.py'
    path.write_text(LATE.replace('FOLDER', str(tmp_path)), encoding='utf-8')
    words = [sys.executable, '-m', 'edulaunch', 'explain', str(path)]
    ended = subprocess.run(words, capture_output=True, text=True, check=True)
    assert 'Traceback' not in ended.stderr
    assert [file.name for file in tmp_path.iterdir()] == ['late.launch.py']

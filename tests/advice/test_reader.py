"""Places as the reader sees them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.advice.reader import Reader, reader_of

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    node = {'package': 'demo_nodes_py', 'executable': 'talker'}
    return LaunchDescription([
        Node(**node), Node(**node)])
"""


def test_paths_below_the_folder_are_short() -> None:
    reader = Reader(folder='/home/me/ws')
    assert reader.place('/home/me/ws/src/a.py', 3) == 'src/a.py:3'
    assert reader.place('/home/me/wss/a.py', None) == '/home/me/wss/a.py'


def test_one_variable_names_the_language() -> None:
    assert reader_of({'LANG': 'de_DE.UTF-8', 'LANGUAGE': 'de'}, '').language == 'en'
    assert reader_of({'EDULAUNCH_LANG': 'de_DE.UTF-8'}, '').language == 'de_DE'


@pytest.fixture
def shell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    from IPython.core.interactiveshell import InteractiveShell

    monkeypatch.chdir(tmp_path)
    InteractiveShell.clear_instance()
    shell: Any = InteractiveShell.instance(colors='nocolor')
    yield shell
    shell.history_manager.end_session()
    InteractiveShell.clear_instance()


def test_in_a_notebook_the_line_of_the_cell_is_named_too(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell('import edulaunch', store_history=True)
    shell.run_cell(f'%%writefile two.launch.py\n{LAUNCH}', store_history=True)
    assert shell.run_cell("recording = edulaunch.run('two.launch.py', duration_s=1.0)", store_history=True).success
    assert 'two.launch.py:6 (line 7 of cell [2]), at 0.00 s' in capsys.readouterr().err
    assert isinstance(shell.user_ns['recording'], edulaunch.Recording)


def test_a_file_that_no_cell_wrote_has_its_own_lines(shell: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'two.launch.py').write_text(LAUNCH)
    shell.run_cell('%%writefile other.launch.py\n1\n2\n3\n4\n5\n6', store_history=True)
    shell.run_cell("import edulaunch; edulaunch.run('two.launch.py', duration_s=1.0)", store_history=True)
    assert '(two.launch.py:6, at 0.00 s)' in capsys.readouterr().err

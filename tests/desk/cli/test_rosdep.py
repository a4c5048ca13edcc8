"""`edulaunch rosdep check`."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main


@pytest.mark.parametrize(
    ('depends', 'code', 'output'),
    [
        ('rclpy', 0, 'All dependencies have been satisfied\n'),
        (
            'rclp',
            1,
            'package.xml:3: robo needs rclp (<exec_depend>), which is not installed; the nearest name is rclpy\n\n'
            'nodes that use a missing dependency cannot run: robo\n',
        ),
    ],
)
def test_check(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], depends: str, code: int, output: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'package.xml').write_text(f'<package>\n  <name>robo</name>\n  <exec_depend>{depends}</exec_depend>\n</package>\n')
    assert (main(['rosdep', 'check']), capsys.readouterr().out) == (code, output)


def test_a_folder_without_packages(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['rosdep', 'check', str(tmp_path)]) == 1
    assert capsys.readouterr().out == f'no package.xml below {tmp_path}\n'

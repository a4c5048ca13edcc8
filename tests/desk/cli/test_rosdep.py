"""`edulaunch rosdep check`."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.workspace.not_needed import answer
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


@pytest.mark.parametrize(
    'words', [['rosdep', 'init'], ['rosdep', 'update', 'now'], ['rosdep', 'install', '--from-paths', 'src', '-y']]
)
def test_what_needs_no_installation_is_explained(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 0
    assert capsys.readouterr().out == answer(words[:2]) + '\n'


@pytest.mark.parametrize(
    ('words', 'asked'), [([], ['build']), (['test', '--packages-select', 'a'], ['test', '--packages-select', 'a'])]
)
def test_colcon_is_explained(words: list[str], asked: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['colcon', *words]) == 0
    assert capsys.readouterr().out == answer(['colcon', *asked]) + '\n'


def test_a_file_is_no_workspace(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'a.txt').write_text('')
    assert main(['rosdep', 'check', str(tmp_path / 'a.txt')]) == 2
    assert capsys.readouterr().err == (
        f"error: '{tmp_path / 'a.txt'}' is not a folder.\n  help: name a workspace, or the folder of a package\n"
    )


def test_two_packages_with_missing_dependencies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ('a', 'b'):
        (tmp_path / name).mkdir()
        (tmp_path / name / 'package.xml').write_text(
            f'<package>\n  <name>{name}</name>\n  <depend>qqqqqqqq</depend>\n  <depend>wwwwwwww</depend>\n</package>\n'
        )
    assert main(['rosdep', 'check']) == 1
    assert capsys.readouterr().out.splitlines() == [
        *(
            f'{name}/package.xml:{line}: {name} needs {missing} (<depend>), which is not installed'
            for name in ('a', 'b')
            for line, missing in ((3, 'qqqqqqqq'), (4, 'wwwwwwww'))
        ),
        '',
        'nodes that use a missing dependency cannot run: a, b',
    ]


def test_the_help_names_each_step(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(['rosdep', '--help'])
    shown = ' '.join(capsys.readouterr().out.split())
    assert 'check list dependencies that neither edulaunch nor the workspace provides' in shown
    assert all(f'{verb} explain why this is not needed' in shown for verb in ('init', 'install', 'update'))

"""`edulaunch doctor`: files, folders, packages and recordings."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main

EXAMPLES = Path(__file__).parents[2] / 'advice' / 'examples'
SAME = str(EXAMPLES / 'programs.same-name' / 'failing.launch.py')


def test_a_launch_file_is_run_and_looked_at(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(EXAMPLES / 'programs.same-name')
    assert main(['doctor', 'failing.launch.py', '--for', '1']) == 1
    assert capsys.readouterr().out == (
        '1. two nodes have the name /talker: one in talker-1 and one in talker-2\n'
        '   where: failing.launch.py:9, at 0.00 s\n'
        '   why:   parameters and services of /talker have the same names in both, so it is not defined which node answers\n'
        "   do:    rename one of them, for example with name='talker_2' in the launch file, or use another namespace\n"
        '   see:   lessons/01_first_launch.ipynb\n'
    )


def test_a_healthy_launch_file_of_a_package(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor', 'turtlesim', 'multisim.launch.py', '--for', '1']) == 0
    assert capsys.readouterr().out == 'no problems found\n'


def test_a_launch_file_that_cannot_be_launched_is_not_run(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor', str(EXAMPLES / 'launch.fails' / 'failing.launch.py')]) == 1
    assert 'launch cannot run this file: ZeroDivisionError' in capsys.readouterr().out


def test_arguments_are_those_of_a_launch(capsys: pytest.CaptureFixture[str]) -> None:
    file = str(EXAMPLES / 'launch.unknown-argument' / 'healthy.launch.py')
    assert main(['doctor', file, 'background_g:=7', '--for', '1']) == 0
    assert main(['doctor', file, 'backgruond_g:=7', '--for', '1']) == 1
    assert "'backgruond_g'" in capsys.readouterr().out


def test_json_has_the_facts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['launch', SAME, '--fast', '--for', '1', '--quiet', '--record', str(tmp_path / 'a.rec')]) == 0
    assert 'warning' not in capsys.readouterr().err
    assert main(['doctor', str(tmp_path / 'a.rec'), '--json']) == 1
    found = json.loads(capsys.readouterr().out)
    assert found['format'] == 1
    (finding,) = found['findings']
    assert (finding['rule'], finding['level'], finding['kind'], finding['name']) == (
        'programs.same-name',
        'warning',
        'node',
        '/talker',
    )
    assert finding['facts'] == {'first': 'talker-1', 'second': 'talker-2', 'other': 'talker_2'} and finding['file'] == SAME


def test_a_folder_is_judged_by_its_sources_and_by_runs_of_its_launch_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(SAME, tmp_path / 'a.launch.py')
    head = 'from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument\nfrom launch_ros.actions import Node\n'
    body = '\n\ndef generate_launch_description():\n    return LaunchDescription([{}])\n'
    (tmp_path / 'b.launch.py').write_text(head + body.format("DeclareLaunchArgument('robot')"))
    (tmp_path / 'c.launch.py').write_text(head + body.format("Node(package='slam_toolbox', executable='slam')"))
    (tmp_path / 'build').mkdir()
    shutil.copy(SAME, tmp_path / 'build' / 'copy.launch.py')
    assert main(['doctor', '.', '--for', '1']) == 1
    out = capsys.readouterr().out
    assert 'two nodes have the name /talker' in out and 'where: a.launch.py:9' in out
    assert out.splitlines()[-3:] == [
        'launch files that ran for 1 simulated seconds each: a.launch.py',
        'b.launch.py did not run: it needs robot:=...',
        'c.launch.py did not run: package slam_toolbox is not installed',
    ]


def test_sarif_has_the_place_and_the_rule(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor', SAME, '--for', '1', '--json', 'sarif']) == 1
    log = json.loads(capsys.readouterr().out)
    (run,) = log['runs']
    (result,) = run['results']
    rule = run['tool']['driver']['rules'][result['ruleIndex']]
    assert log['version'] == '2.1.0' and rule['id'] == 'programs.same-name'
    assert rule['shortDescription']['text'].startswith('two nodes have the name <node>')
    place = result['locations'][0]['physicalLocation']
    assert place == {
        'artifactLocation': {'uri': Path(SAME).as_uri()},
        'region': {'startLine': 9, 'startColumn': 13, 'endLine': 9, 'endColumn': 98},
    }
    assert result['level'] == 'warning' and result['message']['text'].startswith('two nodes have the name /talker')


def test_what_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor', 'no_such.launch.py']) == 2
    assert 'does not exist' in capsys.readouterr().err


def test_ros2_doctor_says_what_the_rules_find_behind_ros_own_checks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from edulaunch.desk.notebook.terminal import CellTerminal

    said: list[str] = []
    terminal = CellTerminal(lambda stream, text: said.append(text))
    monkeypatch.chdir(tmp_path)
    terminal.ros2(f'launch {SAME} --for 1 --quiet')
    assert 'two nodes' not in ''.join(said)
    said.clear()
    terminal.ros2('doctor')
    text = ''.join(said)
    assert (
        text.index('checks passed')
        < text.index('edulaunch has checked everything')
        < text.index('1. two nodes have the name /talker')
    )
    recorded = [row.text for row in terminal.recording().output]
    assert not [text for text in recorded if 'two nodes' in text]


def test_a_syntax_error_of_a_package_is_one_finding_with_the_path_of_the_source(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(EXAMPLES.parent / 'unseen' / 'script_dot' / 'healthy' / 'robo', tmp_path / 'src' / 'robo')
    file = tmp_path / 'src' / 'robo' / 'launch' / 'robo.launch.py'
    file.write_text(file.read_text().replace(', name=', ' name='))
    monkeypatch.chdir(tmp_path)
    for words in (['robo', 'robo.launch.py'], ['.'], [str(file)]):
        assert main(['doctor', *words]) == 1
        shown = capsys.readouterr().out
        assert '1. a comma is missing' in shown and '2. ' not in shown
        assert 'src/robo/launch/robo.launch.py:7\n' in shown
    assert main(['explain', 'robo', 'robo.launch.py']) == 1
    assert f'  at {file}:7\n' in capsys.readouterr().err

"""`edulaunch explain`: what would start and where values come from, without starting anything."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main

TEXT = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('red', default_value='69'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim',
             parameters=[{'background_r': LaunchConfiguration('red')}], remappings=[('a', 'b')]),
        TimerAction(period=2.0, actions=[Node(package='PACKAGE', executable='talker', name='late')]),
    ])
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / 'my.launch.py'
    path.write_text(TEXT.replace('PACKAGE', 'demo_nodes_cpp'))
    return path


def test_nodes_come_with_their_parameters_remaps_and_timers(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['explain', str(file), 'red:=7']) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "├── argument red = '7'  (command line, instead of '69')  <my.launch.py:9>",
        '├── node /sim: turtlesim turtlesim_node  <my.launch.py:10>',
        '│   ├── parameter background_r = 7  (launch argument red)',
        '│   └── remap a -> b',
        '└── timer after 2 s  <my.launch.py:12>',
        '    └── node /late: demo_nodes_cpp talker  <my.launch.py:12>',
        'nodes: 2, other processes: 0, reason for the shutdown: idle',
    ]


def test_the_plan_as_json_is_plan_format_1(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['plan', str(file), '--json']) == 0
    plan = json.loads(capsys.readouterr().out)
    assert (plan['format'], plan['error'], [item['kind'] for item in plan['items']]) == (
        1,
        None,
        ['include', 'argument', 'node', 'timer', 'node'],
    )


def test_missing_packages_are_an_error_unless_assumed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.py'
    path.write_text(TEXT.replace('PACKAGE', 'my_robot').replace("'turtlesim'", "'my_robot'"))
    assert main(['explain', str(path)]) == 1
    err = capsys.readouterr().err
    assert "package 'my_robot' not found" in err and f'{path}:10' in err and '  help: ' in err
    assert main(['explain', str(path), '--assume-packages']) == 0
    shown = capsys.readouterr()
    assert '── node /sim: my_robot turtlesim_node' in shown.out
    assert shown.err == 'missing packages, replaced by empty ones: my_robot\n'


def test_parameter_files_that_are_not_there_stand_below_their_node(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.xml'
    path.write_text(
        '<launch><node pkg="my_robot" exec="a"><param from="$(find-pkg-share my_robot)/a.yaml"/>'
        '<param from="/none/b.yaml"/></node></launch>'
    )
    assert main(['explain', str(path), '--assume-packages']) == 0
    assert capsys.readouterr().out.splitlines()[2:4] == [
        '    ├── parameter file my_robot/a.yaml is missing',
        '    └── parameter file /none/b.yaml is missing',
    ]


def test_configurations_that_outlive_a_reset_are_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.xml'
    path.write_text('<launch><group forwarding="false"><keep name="mode" value="slow"/></group></launch>')
    assert main(['explain', str(path)]) == 0
    assert capsys.readouterr().out.splitlines()[-3:-1] == ['    └── reset configurations', "        └── but mode = 'slow'"]


@pytest.mark.processes
def test_a_terminal_without_line_drawing_gets_a_plain_tree(file: Path) -> None:
    run = subprocess.run(
        [sys.executable, '-m', 'edulaunch', 'explain', str(file)],
        capture_output=True,
        check=True,
        env={**os.environ, 'PYTHONIOENCODING': 'ascii'},
    )
    assert b'\n`-- timer after 2 s' in run.stdout


def test_a_package_without_a_file_gets_the_names_of_its_launch_files(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['explain', 'turtlesim']) == 2
    assert capsys.readouterr().err.endswith('help: name a launch file of turtlesim: multisim.launch.py\n')


def lines_of(capsys: pytest.CaptureFixture[str], *words: object) -> list[str]:
    assert main(['explain', *map(str, words)]) == 0
    return capsys.readouterr().out.splitlines()


def test_explain_as_json_is_the_tree(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = json.loads('\n'.join(lines_of(capsys, file, 'red:=7', '--json')))
    assert (data['format'], data['nodes'], data['given'], data['error']) == (1, 2, {'red': '7'}, None)
    argument, node, _ = data['tree']
    assert (argument['value'], argument['default'], argument['origin'], argument['line']) == ('7', '69', 'command line', 9)
    assert [(one['kind'], one.get('value'), one.get('overrode')) for one in node['children']] == [
        ('parameter', 7, []),
        ('remap', None, None),
    ]


def test_plan_says_that_it_is_called_explain_and_does_the_same(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    explained = lines_of(capsys, file)
    assert main(['plan', str(file)]) == 0
    shown = capsys.readouterr()
    assert shown.out.splitlines() == explained and 'edulaunch explain' in shown.err


def test_why_a_parameter_has_its_value_from_the_default_of_the_node_to_the_winner(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert lines_of(capsys, file, 'red:=7', '/sim', 'background_r') == [
        '/sim  background_r = 7',
        '├── 69  declared by turtlesim_node',
        '└── 7  launch argument red  (this counts)  <my.launch.py:11>',
        "    ├── '69'  default  <my.launch.py:9>",
        "    └── '7'  command line  (this counts)",
    ]
    assert lines_of(capsys, file, '/sim', 'background_g') == [
        '/sim  background_g = 86',
        '└── 86  declared by turtlesim_node  (this counts)',
    ]


def test_why_a_launch_argument_has_its_value(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert lines_of(capsys, file, 'red') == ["launch argument red = '69'", "└── '69'  default  (this counts)  <my.launch.py:9>"]


@pytest.mark.parametrize(
    ('words', 'text', 'help'),
    [
        (('/simm',), "the launch file starts no node '/simm'.", "did you mean '/sim'?"),
        (
            ('/sim', 'backgrond_r'),
            "'/sim' has no parameter 'backgrond_r': it declares none with this name, and the launch file sets none.",
            "'background_r'?",
        ),
        (('rad',), "there is no launch argument 'rad' in this launch file.", "did you mean 'red'?"),
        (('red=5',), "malformed launch argument 'red=5', expected format '<name>:=<value>'", 'write red:=5'),
        (('--diff',), '--diff compares two launch files, or one launch file with two sets of arguments.', '--diff A.launch.py'),
    ],
)
def test_what_cannot_be_explained_is_said_with_the_nearest(
    file: Path, words: tuple[str, ...], text: str, help: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(['explain', str(file), *words]) == 2
    shown = capsys.readouterr().err
    assert text in shown and help in shown


def test_two_sets_of_arguments_are_compared(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    expected = [
        'my.launch.py  ->  my.launch.py red:=7',
        "├── ~ argument red = '7'  (command line, instead of '69')  was '69'  (default)  <my.launch.py:9>",
        '└── node /sim: turtlesim turtlesim_node  <my.launch.py:10>',
        '    └── ~ parameter background_r = 7  (launch argument red)  was 69  (launch argument red)',
    ]
    assert lines_of(capsys, '--diff', file, 'red:=7') == expected
    other = lines_of(capsys, '--diff', file, 'red:=69', 'red:=7')
    assert other[1:] == [expected[1].replace('(default)', "(command line, instead of '69')"), *expected[2:]]


def test_two_launch_files_are_compared(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = file.with_name('other.launch.py')
    other.write_text(file.read_text().replace("name='late'", "name='later'").replace('period=2.0', 'period=3.0'))
    assert lines_of(capsys, '--diff', file, other) == [
        'my.launch.py  ->  other.launch.py',
        '└── ~ timer after 3 s  was 2 s  <other.launch.py:12>',
        '    ├── - node /late: demo_nodes_cpp talker  <my.launch.py:12>',
        '    └── + node /later: demo_nodes_cpp talker  <other.launch.py:12>',
    ]
    assert lines_of(capsys, '--diff', file, file) == ['my.launch.py  ->  my.launch.py', 'no difference']


@pytest.mark.processes
@pytest.mark.parametrize('width', ['40', '100'])
def test_a_narrow_terminal_keeps_the_branches(file: Path, width: str) -> None:
    code = (
        'from edulaunch.advice.explaining import explain\nfrom edulaunch.advice.explaining.tree import print_in_colour\n'
        f'tree = explain({str(file)!r})\nprint_in_colour("my.launch.py", tree.entries)'
    )
    env = {**os.environ, 'COLUMNS': width, 'PYTHONIOENCODING': 'utf-8', 'NO_COLOR': '1', 'TERM': 'xterm'}
    lines = subprocess.run([sys.executable, '-c', code], capture_output=True, check=True, env=env).stdout.decode().splitlines()
    assert all(len(line) <= int(width) for line in lines)
    assert all(line[0] in '├└│ ' for line in lines[1:])


def test_a_terminal_shows_colours_and_only_colours_more(
    file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = lines_of(capsys, file)
    monkeypatch.setattr('sys.stdout.isatty', lambda: True)
    monkeypatch.delenv('NO_COLOR', raising=False)
    monkeypatch.setenv('TERM', 'xterm')
    monkeypatch.setenv('COLUMNS', '300')
    shown = lines_of(capsys, file)
    assert [re.sub(r'\x1b\[[0-9;]*m', '', line) for line in shown] == plain
    assert any('\x1b[1;32mnode ' in line for line in shown)


def test_a_picture_and_a_page_of_the_plan(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture, page = str(tmp_path / 'plan.png'), str(tmp_path / 'plan.html')
    assert main(['explain', str(file), '--graph', picture]) == 0
    out = capsys.readouterr().out
    assert '  subscribes to /turtle1/cmd_vel [geometry_msgs/msg/Twist]' in out and out.endswith(f'{picture}\n')
    assert Path(picture).read_bytes().startswith(b'\x89PNG')
    assert main(['explain', str(file), '--graph', page]) == 0
    assert 'openDesk' in Path(page).read_text(encoding='utf-8')


def test_two_plans_side_by_side(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = str(tmp_path / 'two.png')
    assert main(['explain', '--diff', str(file), 'red:=1', 'red:=2', '--graph', picture]) == 0
    assert '~ /sim parameter background_r = 2, before 1\n' in capsys.readouterr().out
    assert Path(picture).read_bytes().startswith(b'\x89PNG')


def test_a_page_of_two_plans_has_both_graphs_and_each_difference(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / 'two.html'
    assert main(['explain', '--diff', str(file), 'red:=1', 'red:=<b>', '--graph', str(page)]) == 0
    assert capsys.readouterr().out.endswith(f'{page}\n')
    text = page.read_text(encoding='utf-8')
    assert '~ differs</td><td>/sim parameter background_r = &#x27;&lt;b&gt;&#x27;, before 1</td>' in text
    assert 'src="data:image/png;base64,iVBOR' in text and 'alt="' in text and '<b>' not in text


def test_a_graph_of_another_kind_is_refused(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['explain', str(file), '--graph', str(tmp_path / 'plan.pdf')]) == 2
    assert main(['explain', str(file), '--graph', str(tmp_path / 'no' / 'plan.png')]) == 2
    err = capsys.readouterr().err
    assert 'name a file that ends with .png or .html' in err
    assert 'error: cannot write ' in err and 'plan.png: ' in err


def test_an_earlier_run_gives_the_endpoints(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    demo = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
    run, picture = str(tmp_path / 'run.rec'), str(tmp_path / 'plan.png')
    assert main(['launch', *demo, '--fast', '--for', '2', '--record', run]) == 0
    assert main(['explain', *demo, '--graph', picture, '--run', run]) == 0
    assert '  publishes /turtle2/pose' in capsys.readouterr().out

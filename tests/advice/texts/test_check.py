"""`check` marks each mistake at its column, with the edit that cures it, and says nothing of healthy files."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.texts import Around, check, kind_of
from edulaunch.advice.texts.edits import applied
from tests.house import ROOT

HEAD = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
"""
TAIL = '    ])\n'


def in_list(*lines: str) -> str:
    return HEAD + ''.join(f'        {line}\n' for line in lines) + TAIL


def told(text: str, path: Path) -> list[tuple[int, str, str, str | None]]:
    """(line, rule, what is marked, the marked line after the edit) of each finding, in the order of the text."""
    found = []
    for mark in sorted(check(text, str(path)), key=lambda one: one.span):
        line = text.count('\n', 0, mark.span.start) + 1
        cured = applied(text, mark.edits).splitlines()[line - 1] if mark.edits else None
        found.append((line, mark.finding.rule, text[mark.span.start : mark.span.end], cured and cured.strip()))
    return found


@pytest.mark.parametrize(
    ('line', 'rule', 'marked', 'cured'),
    [
        ("LogInfo(mgs='a'),", 'launch.keyword', 'mgs=', "LogInfo(msg='a'),"),
        ("LogInfo('a'),", 'launch.positional', "'a'", None),
        ('Node(package="turtlesim"),', 'launch.missing-keyword', 'Node', None),
        ("Node(package='turtlesm', executable='x'),", 'packages.unknown', 'turtlesm', "Node(package='turtlesim', executable='x'),"),
        ("Node(package='turtlesim', executable='turtlesim_nod'),", 'packages.no-executable', 'turtlesim_nod', "Node(package='turtlesim', executable='turtlesim_node'),"),
        ("LogInfo(msg=LaunchConfiguratoin('a')),", 'launch.unknown-name', 'LaunchConfiguratoin', "LogInfo(msg=LaunchConfiguration('a')),"),
        ("LogInfo(msg='é', condition=none),", 'launch.unknown-name', 'none', "LogInfo(msg='é', condition=None),"),
        ("DeclareLaunchArgument('turtle'), LogInfo(msg=LaunchConfiguration('turtel')),", 'launch.no-configuration', 'turtel', "DeclareLaunchArgument('turtle'), LogInfo(msg=LaunchConfiguration('turtle')),"),
        ("LogInfo(msg=['a' 'b']),", 'programs.joined-strings', "'a' 'b'", "LogInfo(msg=['a', 'b']),"),
        ("LogInfo(msg='a') LogInfo(msg='b'),", 'programs.no-comma', "LogInfo(msg='a') LogInfo(msg='b')", "LogInfo(msg='a'), LogInfo(msg='b'),"),
        ("LogInfo(msg='a')(LogInfo(msg='b')),", 'launch.missing-comma', ')', "LogInfo(msg='a'),(LogInfo(msg='b')),"),
        ('LogInfo(msg=\u2018a\u2019),', 'programs.typographic-quotes', '\u2018', "LogInfo(msg='a'),"),
    ],
)  # fmt: skip
def test_a_mistake_of_a_python_launch_file_is_marked_with_its_cure(
    tmp_path: Path, line: str, rule: str, marked: str, cured: str | None
) -> None:
    assert told(in_list(line), tmp_path / 'a.launch.py') == [(9, rule, marked, cured)]


def test_several_mistakes_are_marked_at_once(tmp_path: Path) -> None:
    text = in_list("LogInfo(mgs='a'),", "Node(package='turtlesm', executable='turtlesim_node'),", 'PushRosNamespace("x"),')
    assert [(line, rule) for line, rule, _, _ in told(text, tmp_path / 'a.launch.py')] == [
        (9, 'launch.keyword'),
        (10, 'packages.unknown'),
        (11, 'launch.setting-after-nodes'),
        (11, 'launch.unknown-name'),
    ]


def test_a_name_without_an_import_gets_its_line_among_the_imports(tmp_path: Path) -> None:
    text = in_list('TimerAction(period=1.0, actions=[]),')
    (mark,) = check(text, str(tmp_path / 'a.launch.py'))
    assert applied(text, mark.edits) == text.replace(
        'from launch_ros.actions import Node\n', 'from launch_ros.actions import Node\nfrom launch.actions import TimerAction\n'
    )


@pytest.mark.parametrize(
    ('old', 'new', 'rule', 'marked', 'cured'),
    [
        ('launch.actions', 'launch.actoins', 'launch.no-module', 'launch.actoins', 'launch.actions'),
        ('LogInfo\n', 'LogInof\n', 'launch.import-name', 'LogInof', 'LogInfo\n'),
        ('from launch import LaunchDescription', 'from launch.actions import LaunchDescription', 'launch.import-name', 'LaunchDescription', 'from launch import LaunchDescription'),
        ('def generate_launch_description', 'def generate_launch_descripton', 'launch.no-generate', 'def generate_launch_descripton', 'def generate_launch_description'),
        ('    return LaunchDescription', '    LaunchDescription', 'launch.no-return', 'generate_launch_description', None),
        ('description():', 'description()', 'programs.no-colon', None, 'description():'),
    ],
)  # fmt: skip
def test_mistakes_around_the_list(tmp_path: Path, old: str, new: str, rule: str, marked: str | None, cured: str | None) -> None:
    text = in_list().replace(old, new, 1)
    mark = next(one for one in check(text, str(tmp_path / 'a.launch.py')) if one.finding.rule == rule)
    assert marked in (None, text[mark.span.start : mark.span.end])
    assert (in_list() if cured else text) == applied(text, mark.edits)


@pytest.mark.parametrize(
    ('name', 'text', 'rule', 'marked', 'cured'),
    [
        ('a.launch.xml', '<launch>\n<nod pkg="turtlesim" exec="turtlesim_node"/>\n</launch>', 'launch.unknown-element', 'nod', None),
        ('a.launch.xml', '<launch>\n<node pgk="turtlesim" exec="turtlesim_node"/>\n</launch>', 'launch.unknown-attribute', 'pgk', 'pkg'),
        ('a.launch.xml', '<launch>\n<node pkg="turtlesm" exec="turtlesim_node"/>\n</launch>', 'packages.unknown', 'turtlesm', 'turtlesim'),
        ('a.launch.xml', '<launch>\n<node pkg="turtlesim" exec="turtlesim_nod"/>\n</launch>', 'packages.no-executable', 'turtlesim_nod', 'turtlesim_node'),
        ('a.launch.xml', '<launch>\n<log message="$(arg x)"/>\n</launch>', 'launch.call', '$(arg', '$(var '),
        ('a.launch.xml', '<launch>\n<arg name="who" default="a"/>\n<log message="$(var woh)"/>\n</launch>', 'launch.no-configuration', 'woh', 'who'),
        ('a.launch.xml', '<launch>\n<group>\n</launch>', 'launch.not-closed', None, None),
        ('a.launch.yaml', 'launch:\n- node: {pkg: turtlesm, exec: turtlesim_node}\n', 'packages.unknown', 'turtlesm', 'turtlesim'),
        ('a.launch.yaml', 'launch:\n- nodes: {pkg: turtlesim, exec: turtlesim_node}\n', 'launch.unknown-element', 'nodes', None),
        ('a.yaml', 'sim:\n  ros_parameters:\n    x: 1\n', 'launch.parameters-key', 'ros_parameters', 'ros__parameters'),
        ('a.yaml', 'sim:\n  ros__parameters:\n    x: [1, 2.0]\n', 'launch.list-of-one-type', None, None),
        ('a.py', 'import rclpy\nfrom geometry_msgs.msg import Twits\n', 'messages.no-interface', 'Twits', 'Twist'),
        ('a.py', 'import rclpy\nfrom geometry_mgs.msg import Twist\n', 'messages.unknown-package', 'geometry_mgs', 'geometry_msgs'),
        ('a.py', 'import rclpy\nfrom geometry_msgs.msg import Twist\ndef f():\n    t = Twist()\n    t.linear.xx = 1.0\n', 'messages.field', '.xx', '.x'),
        ('a.py', 'import rclpy\nclass A(Node):\n    pass\n', 'programs.unknown-name', 'Node', 'from rclpy.node import Node'),
    ],
)  # fmt: skip
def test_other_files(tmp_path: Path, name: str, text: str, rule: str, marked: str | None, cured: str | None) -> None:
    (mark,) = check(text, str(tmp_path / name))
    assert (mark.finding.rule, mark.finding.file) == (rule, str(tmp_path / name))
    assert marked in (None, text[mark.span.start : mark.span.end])
    assert (cured is None) == (not mark.edits) and (cured or '') in applied(text, mark.edits)
    assert check(applied(text, mark.edits), str(tmp_path / name)) == [] or not mark.edits


def test_healthy_files_get_no_remark() -> None:
    files = [
        path
        for folder in ('solutions', 'tests/advice/healthy', 'edulaunch/ros/share')
        for path in sorted((ROOT / folder).rglob('*.*'))
    ]
    around: dict[Path, Around] = {}
    looked_at = 0
    for path in files:
        if path.suffix not in ('.py', '.xml', '.yaml') or path.name == 'package.xml':
            continue
        text = path.read_text(encoding='utf-8')
        looked_at += kind_of(str(path), text) is not None
        known = around.setdefault(path.parent, Around(str(path)))
        assert [(mark.finding.rule, mark.finding.name) for mark in check(text, str(path), known)] == [], path
    assert looked_at > 60


def test_nothing_of_the_text_is_executed(tmp_path: Path) -> None:
    text = f"open({str(tmp_path / 'made')!r}, 'w')\n" + in_list("LogInfo(mgs='a'),")
    assert [mark.finding.rule for mark in check(text, str(tmp_path / 'a.launch.py'))] == ['launch.keyword']
    assert not (tmp_path / 'made').exists()


def test_files_of_others_are_not_looked_at(tmp_path: Path) -> None:
    assert (
        check('print(x)\n', str(tmp_path / 'a.py'))
        == check('<svg/>', str(tmp_path / 'a.xml'))
        == check('a: 1\n', str(tmp_path / 'a.yaml'))
        == []
    )

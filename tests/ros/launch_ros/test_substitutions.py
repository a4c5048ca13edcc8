"""Substitutions that look into packages."""

from __future__ import annotations

from typing import Any

import pytest
from launch.actions import LogInfo, OpaqueFunction
from launch_ros.actions import Node
from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix, FindPackageShare

import edulaunch
from edulaunch.engine.facts import facts_of
from edulaunch.engine.packages import Index


def performed(run: Any, substitution: Any) -> Any:
    """The text, or the exception, inside a launch with the package `robo`."""
    found: list[Any] = []

    def perform(context: Any) -> None:
        try:
            found.append(substitution.perform(context))
        except Exception as error:
            found.append(error)

    run(OpaqueFunction(function=perform))
    return found[0]


def test_packages_and_executables_are_found(run: Any, robo: Index) -> None:
    prefix = robo.search_paths()[0]
    assert performed(run, FindPackagePrefix('robo')) == prefix
    assert performed(run, FindPackageShare(['ro', 'bo'])) == f'{prefix}/share/robo'
    assert performed(run, ExecutableInPackage('drive', 'robo')) == f'{prefix}/lib/robo/drive'


def test_a_missing_executable_gives_the_text_of_ros_and_a_hint(run: Any, robo: Index) -> None:
    error = performed(run, ExecutableInPackage('drvie', 'robo'))
    assert str(error) == f"executable 'drvie' not found on the libexec directory '{robo.search_paths()[0]}/lib/robo' "
    assert facts_of(error)['near'] == 'drive'


def test_a_package_without_executables_has_no_libexec_directory(run: Any, tmp_path: Any) -> None:
    marker = tmp_path / 'opt/share/ament_index/resource_index/packages/bare'
    marker.write_text('', encoding='utf-8')
    error = performed(run, ExecutableInPackage('x', 'bare'))
    assert (
        str(error) == f"package 'bare' found at '{tmp_path}/opt', but libexec directory '{tmp_path}/opt/lib/bare' does not exist"
    )
    assert (facts_of(error)['about'], facts_of(error)['known']) == ('packages.no-executable', [])


def test_a_c_plus_plus_executable_is_found_and_ends_with_a_sentence_while_others_go_on(tmp_path: Any) -> None:
    (tmp_path / 'CMakeLists.txt').write_text(
        'project(robo_cpp)\nadd_executable(fast a.cpp)\ninstall(TARGETS fast DESTINATION lib/robo_cpp)'
    )
    (tmp_path / 'package.xml').write_text('<package><name>robo_cpp</name></package>')
    (tmp_path / 'robo.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import LogInfo, TimerAction\n'
        'from launch_ros.actions import Node\ndef generate_launch_description():\n    return LaunchDescription(['
        "Node(package='robo_cpp', executable='fast'), TimerAction(period=1.0, actions=[LogInfo(msg='goes on')])])"
    )
    with edulaunch.Session(workspaces=[tmp_path]) as session:
        session.launch(tmp_path / 'robo.launch.py')
        session.run(2.0)
        recording = session.recording()
    assert (
        f'this program is built from C++ ({tmp_path}/CMakeLists.txt:2), but edulaunch runs only Python programs'
        in recording.warnings[0]
    )
    assert recording.output[-1].text == '[INFO] [launch.user]: goes on\n'


def test_a_package_with_c_plus_plus_programs_only_tells_of_another_name_as_ros_does(tmp_path: Any) -> None:
    (tmp_path / 'CMakeLists.txt').write_text(
        'project(robo_cpp)\nadd_executable(fast a.cpp)\ninstall(TARGETS fast DESTINATION lib/robo_cpp)'
    )
    (tmp_path / 'package.xml').write_text('<package><name>robo_cpp</name></package>')
    (tmp_path / 'robo.launch.xml').write_text('<launch><node pkg="robo_cpp" exec="fats"/></launch>')
    with pytest.raises(
        edulaunch.LaunchFileError, match="executable 'fats' not found on the libexec directory '.*/lib/robo_cpp' "
    ) as e:
        edulaunch.run(tmp_path / 'robo.launch.xml', duration_s=1, workspaces=[tmp_path])
    assert e.value.help is not None and "write 'fast'" in e.value.help


def test_a_node_of_a_missing_package_stops_the_launch_before_anything_starts(run: Any) -> None:
    launched = run(LogInfo(msg='x'), Node(package='robo', executable='drive'), Node(package='rob', executable='drive'))
    assert launched.specs == []
    assert "package 'rob' not found, searching: ['" in launched.logs[0][2]


@pytest.mark.parametrize(
    ('substitution', 'text'),
    [(FindPackageShare('p'), "FindPackageShare(pkg='p')"), (ExecutableInPackage('e', 'p'), "ExecInPkg(pkg='p', exec='e')")],
)
def test_descriptions_are_those_that_show_args_prints(substitution: Any, text: str) -> None:
    assert substitution.describe() == text

"""Every launch ends: after an action that fails, and after Ctrl-C at any instant."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

from edulaunch.engine.packages.discovery import find_workspaces
from edulaunch.runtime.session import Session

ROOT = Path(__file__).resolve().parents[2]
ENDS_WITHIN_S = 25.0
"""Simulated seconds: launch sends SIGTERM after five, SIGKILL after ten."""
INSTANTS = 50
FAILING = """from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription(
        [IncludeLaunchDescription(AnyLaunchDescriptionSource({path!r})), LogInfo(msg=LaunchConfiguration('nobody_declares_it'))]
    )
"""
CONTAINER = """from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    talker = ComposableNode(package='composition', plugin='composition::Talker', name='talker')
    return LaunchDescription([ComposableNodeContainer(
        name='c', namespace='', package='rclcpp_components', executable='component_container', composable_node_descriptions=[talker]
    )])
"""
FILES = sorted(
    str(path.relative_to(ROOT))
    for folder in ('tests/corpus', 'solutions', 'exercises')
    for path in (ROOT / folder).rglob('*launch*')
    if path.suffix in ('.py', '.xml', '.yaml') and path.is_file()
)


def begun(path: Path, workspace_of: Path) -> Session:
    return Session(workspaces=find_workspaces(str(workspace_of.parent), {}, str(workspace_of)), console=lambda stream, text: None)


def has_ended(session: Session) -> bool:
    """Whether it ends by itself within the time that it has."""
    if not session.is_over:
        session.sim.run(session.sim.now_ns + round(ENDS_WITHIN_S * 1e9))
    return session.is_over


def ends_after_a_failure(path: Path, folder: Path) -> bool:
    failing = folder / 'failing.launch.py'
    failing.write_text(FAILING.format(path=str(path)))
    with begun(failing, path) as session:
        session.launch(failing)
        return has_ended(session)


def instants_of(position: int) -> list[int]:
    """Two of the instants, others for each file: all files together meet each instant five times."""
    return [position * 2 % INSTANTS, (position * 2 + INSTANTS // 2) % INSTANTS]


def never_ends_from(path: Path, instants: Iterable[int] = range(0, INSTANTS, 10)) -> list[int]:
    """The instants (by number) at which Ctrl-C does not end it."""
    found = []
    for number in instants:
        with begun(path, path) as session:
            session.launch(path)
            for _ in range(number):
                next_ns = session.sim.next_time_ns()
                if next_ns is None:
                    break
                session.sim.run(next_ns)
            session.interrupt()
            if not has_ended(session):
                found.append(number)
    return found


def test_a_container_beside_an_action_that_fails(tmp_path: Path) -> None:
    path = tmp_path / 'container.launch.py'
    path.write_text(CONTAINER)
    assert ends_after_a_failure(path, tmp_path)
    assert never_ends_from(path) == []


@pytest.mark.whole
@pytest.mark.parametrize(('file', 'instants'), [(file, instants_of(position)) for position, file in enumerate(FILES)], ids=FILES)
def test_each_launch_file(file: str, instants: list[int], tmp_path: Path) -> None:
    assert ends_after_a_failure(ROOT / file, tmp_path)
    assert never_ends_from(ROOT / file, instants) == []

"""What `import edulaunch` gives and costs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.errors import UnusableInput

ROOT = Path(__file__).resolve().parents[1]


def fresh(code: str) -> str:
    """Run code in a fresh interpreter, as a user of the installed package would."""
    done = subprocess.run(
        [sys.executable, '-c', f'import sys\nsys.path.insert(0, {str(ROOT)!r})\n{code}'],
        capture_output=True,
        text=True,
        check=True,
        env={name: value for name, value in os.environ.items() if name != 'PYTHONPATH'},  # of an activated environment
    )
    return done.stdout.strip()


def test_all_names_are_there_sorted_and_few() -> None:
    assert edulaunch.__all__ == sorted(edulaunch.__all__) and len(edulaunch.__all__) <= 20
    assert all(getattr(edulaunch, name) is not None for name in edulaunch.__all__)


def test_the_page_on_the_public_interface_names_exactly_these_and_each_has_a_docstring() -> None:
    page = (ROOT / 'docs' / 'public_api.md').read_text('utf-8')
    assert sorted(re.findall(r'^\| `edulaunch\.(\w+)` \|', page, re.M)) == edulaunch.__all__
    assert [name for name in edulaunch.__all__ if not (getattr(edulaunch, name).__doc__ or '').strip()] == []


@pytest.mark.processes
def test_importing_changes_no_path_and_loads_nothing_heavy() -> None:
    assert (
        fresh(
            'before = list(sys.path)\nimport edulaunch\n'
            'heavy = {"numpy", "matplotlib", "yaml", "asyncio", "greenlet", "typing"} & set(sys.modules)\n'
            'print(before == sys.path, sorted(heavy))'
        )
        == 'True []'
    )


@pytest.mark.processes
def test_every_room_can_be_imported_before_ros_can_be() -> None:
    folder = Path(edulaunch.__file__).parent
    places = [path.parent.relative_to(folder) for depth in ('*', '*/*') for path in folder.glob(f'{depth}/__init__.py')]
    rooms = sorted('.'.join(place.parts) for place in places)
    assert 'advice.plan' in rooms
    assert (
        fresh(
            f'import edulaunch, importlib\nfor room in {rooms}: importlib.import_module("edulaunch." + room)\nprint("launch" in sys.modules)'
        )
        == 'False'
    )


@pytest.mark.processes
def test_running_a_launch_file_loads_neither_numpy_nor_matplotlib() -> None:
    assert (
        fresh(
            'import edulaunch\nedulaunch.run("turtlesim", "multisim.launch.py", duration_s=0.5)\n'
            'print(sorted({"numpy", "matplotlib"} & set(sys.modules)))'
        )
        == '[]'
    )


@pytest.mark.processes
def test_a_foreign_ros_is_not_shadowed(tmp_path: Path) -> None:
    foreign = tmp_path / 'rclpy'
    foreign.mkdir()
    (foreign / '__init__.py').write_text('')
    assert (
        fresh(
            f'sys.path.append({str(tmp_path)!r})\nimport edulaunch\nbefore = list(sys.path)\n'
            'try:\n    edulaunch.source()\nexcept edulaunch.EdulaunchError as error:\n'
            f'    print({str(foreign)!r} in str(error), before == sys.path)'
        )
        == 'True True'
    )


@pytest.mark.processes
def test_a_wrong_name_is_an_attribute_error() -> None:
    assert fresh('import edulaunch\ntry:\n    edulaunch.runn\nexcept AttributeError as error:\n    print(error)') == (
        "module 'edulaunch' has no attribute 'runn'"
    )


def test_what_a_session_ends_by_closing_is_not_recorded(tmp_path: Path) -> None:
    script = tmp_path / 'script.py'
    script.write_text('import time\ntry:\n    time.sleep(100)\nfinally:\n    print("the end")\n')
    file = tmp_path / 'a.launch.py'
    file.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        f'def generate_launch_description():\n    return LaunchDescription([ExecuteProcess(cmd=["python3", {str(script)!r}])])\n'
    )
    with edulaunch.Session() as session:
        session.launch(file)
        session.run(1.0)
        before = len(session.recorder.output_lines)
    assert [row['returncode'] for row in session.recorder.processes] == [None, None]
    assert len(session.recorder.output_lines) == before
    assert session.recorder.content()['duration_ns'] == 10**9


@pytest.mark.parametrize('duration', ['2', float('nan'), float('inf'), -1, [2]])
def test_a_duration_that_is_none_is_told(duration: Any) -> None:
    with pytest.raises(UnusableInput, match='duration_s must be a number of simulated seconds, not .*\n  help: write a number'):
        edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=duration)


@pytest.mark.processes
def test_each_view_of_a_recording_is_found_though_nobody_has_imported_its_wing() -> None:
    for name in ('plot_turtles', 'parameter_table', 'message_table', 'replay', 'judge'):
        assert (
            fresh(f'import edulaunch\nfrom edulaunch.engine.recording.views import view\nprint(callable(view({name!r})))')
            == 'True'
        )

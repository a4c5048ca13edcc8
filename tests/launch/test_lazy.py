"""Names are imported when used, and nobody notices."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGES = [
    'launch',
    'launch.actions',
    'launch.conditions',
    'launch.descriptions',
    'launch.event_handlers',
    'launch.events',
    'launch.events.process',
    'launch.launch_description_sources',
    'launch.substitutions',
    'launch.utilities',
]


@pytest.mark.parametrize('package', PACKAGES)
def test_every_exported_name_is_there_and_lives_below_its_package(package: str) -> None:
    module = importlib.import_module(package)
    for name in dir(module):
        value = getattr(module, name)
        assert getattr(value, '__module__', 'launch').startswith('launch') or name.startswith('Some')


@pytest.mark.parametrize('package', PACKAGES)
def test_star_imports_everything(package: str) -> None:
    names: dict[str, object] = {}
    exec(f'from {package} import *', names)
    assert set(importlib.import_module(package).__all__) <= set(names)


def test_a_missing_name_gives_pythons_own_error() -> None:
    import launch.actions

    with pytest.raises(ImportError) as error:
        from launch.actions import IfCondition  # noqa: F401
    assert str(error.value) == f"cannot import name 'IfCondition' from 'launch.actions' ({launch.actions.__file__})"
    with pytest.raises(AttributeError, match="module 'launch.actions' has no attribute 'X'"):
        _ = launch.actions.X


def test_modules_are_attributes_without_an_import() -> None:
    code = (
        'import launch\nlaunch.actions.timer_action.TimerAction\nlaunch.event_handlers.OnProcessExit\n'
        'launch.launch_description_sources.PythonLaunchDescriptionSource\nlaunch.substitution.Substitution'
    )
    _run(code)


def test_a_description_can_be_built_without_asyncio_logging_or_yaml() -> None:
    _run(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess, TimerAction\n'
        'TimerAction(period=1.0, actions=[])\nimport sys\n'
        'assert not {"asyncio", "logging", "yaml", "numpy", "matplotlib", "argparse"} & set(sys.modules)'
    )


def _run(code: str) -> None:
    root = Path(__file__).resolve().parents[2]
    start = f'import sys; sys.path[:0] = [{str(root)!r}, {str(root / "edulaunch" / "underlay" / "python")!r}]\n'
    subprocess.run([sys.executable, '-S', '-c', start + f'sys.path += {sys.path!r}\n' + code], check=True)

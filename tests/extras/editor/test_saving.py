"""The dry run of a saved file: what it finds, that it is confined, and that it ends at its deadline."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.extras.editor.saving import saved_check

pytestmark = pytest.mark.processes
HEAD = 'import ctypes, os, socket\nfrom launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument\n\ndef generate_launch_description():\n'


def written(folder: Path, body: str) -> str:
    path = folder / 'a.launch.py'
    path.write_text(HEAD + body, encoding='utf-8')
    return str(path)


def test_findings_and_values_come_back(tmp_path: Path) -> None:
    found = saved_check(written(tmp_path, "    return LaunchDescription([DeclareLaunchArgument('a', default_value='1')])\n"), [])
    assert found is not None
    assert [one[-2] for one in found['findings']] == ['launch.argument-unused', 'launch.starts-nothing']
    assert [step['value'] for step in found['values']['a']] == ['1']


@pytest.mark.parametrize('module', ['json', 'resource', 'tempfile'])
def test_a_file_beside_it_with_the_name_of_a_module_is_not_imported(tmp_path: Path, module: str) -> None:
    (tmp_path / f'{module}.py').write_text(f"open({str(tmp_path / 'made')!r}, 'w')\n", encoding='utf-8')
    assert saved_check(written(tmp_path, '    return LaunchDescription([])\n'), []) is not None
    assert not (tmp_path / 'made').exists()


def test_the_child_cannot_write_elsewhere_nor_reach_the_network(tmp_path: Path) -> None:
    made = tmp_path / 'made'
    body = f"""    libc = ctypes.CDLL(None, use_errno=True)
    opened = libc.creat64({str(made).encode()!r}, 0o600)
    connected = libc.socket(2, 1, 0)
    raise RuntimeError(f'opened {{opened}}, connected {{connected}}')
"""
    found = saved_check(written(tmp_path, body), [])
    assert found is not None
    if set(found['confined'].values()) != {'held'}:
        pytest.skip(f'this system cannot confine: {found["confined"]}')
    assert not made.exists()
    assert 'opened -1, connected -1' in str(found['findings'])


def test_it_ends_at_its_deadline(tmp_path: Path) -> None:
    path = written(tmp_path, '    libc = ctypes.CDLL(None)\n    while True:\n        libc.sleep(1000)\n')
    assert saved_check(path, [], deadline_s=1.5) is None

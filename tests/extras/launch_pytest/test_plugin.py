"""The pytest plugin: when it is asked for, and what the tests of a workspace find."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.extras.pytest_plugin.asked import uses_launch_pytest

from .conftest import PREAMBLE, Run
from .sources import ALIVE


@pytest.mark.parametrize(
    ('source', 'imported', 'answer'),
    [
        (b'import launch_pytest', False, True),
        (b'@pytest.mark.launch(fixture=f)\ndef test(): ...', True, True),
        (b"@pytest.mark.launch('a browser')\ndef test(): ...", False, False),
        (b'TEXT = "import launch_pytest"', True, False),
        (b'def test_plain(): ...', True, False),
    ],
)
def test_a_mark_of_somebody_else_is_left_alone(
    source: bytes, imported: bool, answer: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not imported:
        monkeypatch.delitem(sys.modules, 'launch_pytest', raising=False)
    else:
        monkeypatch.setitem(sys.modules, 'launch_pytest', sys)
    assert uses_launch_pytest(source) is answer


def test_a_test_file_sees_its_workspace(inner: Run, tmp_path: Path) -> None:
    package = tmp_path / 'pkg'
    package.mkdir()
    (tmp_path / 'package.xml').write_text(
        '<package format="3"><name>pkg</name><version>0.0.1</version><description>d</description><maintainer email="a@b.c">m'
        '</maintainer><license>MIT</license><export><build_type>ament_python</build_type></export></package>'
    )
    (tmp_path / 'setup.py').write_text(
        "from setuptools import setup\nsetup(name='pkg', version='0.0.1', packages=['pkg'], "
        "entry_points={'console_scripts': ['wait = pkg.node:main']})\n"
    )
    (tmp_path / 'setup.cfg').write_text('[develop]\nscript_dir=$base/lib/pkg\n[install]\ninstall_scripts=$base/lib/pkg\n')
    (package / '__init__.py').write_text('')
    (package / 'node.py').write_text('import time\ndef main():\n    time.sleep(4)\n    return 3\n')
    done = inner("""
from pkg.node import main
@pytest.fixture
def proc():
    return Node(package='pkg', executable='wait')
@launch_pytest.fixture
def waiting(proc):
    return launch.LaunchDescription([proc])
@pytest.mark.launch(fixture=waiting)
def test_it(proc, launch_context):
    began = time.time()
    assert main() == 3 and time.time() - began == 4
    assert tools.wait_for_exit_sync(launch_context, proc, timeout=1) and proc.return_code == 3
""")
    assert done.outcomes == [('test_it', 'passed')], done.text


@pytest.mark.whole
def test_a_run_of_its_own_finds_ros_for_conftests_and_inner_runs_do_not_disturb_each_other(tmp_path: Path) -> None:
    (tmp_path / 'conftest.py').write_text('from std_msgs.msg import String\nimport launch_pytest\n')
    (tmp_path / 'test_outer.py').write_text(f"""
pytest_plugins = ['pytester']
SOURCE = {PREAMBLE + ALIVE!r} + '''
@pytest.mark.launch(fixture=alive, shutdown=True)
def test_it(launch_service):
    assert launch_service._is_idle()
'''
def test_first(pytester):
    pytester.makepyfile(SOURCE)
    pytester.runpytest('-p', 'edulaunch.extras.pytest_plugin').assert_outcomes(passed=1)
test_second = test_first
""")
    here = str(Path(__file__).resolve().parents[3])
    env = {**os.environ, 'PYTHONPATH': here, 'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1', 'PYTHONDONTWRITEBYTECODE': '1'}
    command = [
        sys.executable,
        '-m',
        'pytest',
        '-q',
        '-p',
        'edulaunch.extras.pytest_plugin',
        '-p',
        'no:cacheprovider',
        str(tmp_path),
    ]
    done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert '2 passed' in done.stdout, done.stdout + done.stderr

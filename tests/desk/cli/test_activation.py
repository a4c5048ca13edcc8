"""One line, `source .venv/bin/activate`, sets a shell up; `deactivate` takes it back."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import venv
from collections.abc import Mapping
from pathlib import Path

import pytest

from edulaunch.desk.cli.activation import install
from edulaunch.desk.cli.main import main
from edulaunch.engine.underlay_place import underlay_prefix, underlay_python
from edulaunch.errors import UnusableInput

START = {'bash': ('bash', '--norc', '--noprofile'), 'zsh': ('zsh', '-f'), 'fish': ('fish', '--no-config')}
SETTINGS = {'bash': '.bashrc', 'zsh': '.zshrc', 'fish': '.config/fish/config.fish'}
OURS = {'source', '.', 'sudo', 'apt', 'colcon', 'rviz2', 'gz', 'deactivate'}
SAVED = 'PYTHONPATH', 'AMENT_PREFIX_PATH', 'ROS_DISTRO', 'ROS_VERSION', 'ROS_PYTHON_VERSION', 'PATH'


@pytest.fixture
def environment(tmp_path: Path) -> Path:
    """A virtual environment whose `edulaunch` is that of these tests."""
    prefix = tmp_path / 'a folder' / '.venv'
    venv.EnvBuilder(symlinks=True).create(prefix)
    for name, module in (('edulaunch', 'edulaunch'), ('edugrade', 'edugrade')):
        program = prefix / 'bin' / name
        program.write_text(f'#!/bin/sh\nexec {sys.executable} -m {module} "$@"\n')
        program.chmod(0o755)
    install(prefix)
    return prefix


def shell(name: str, home: Path, lines: str, *options: str, env: Mapping[str, str] = {}) -> list[str]:
    """What a shell prints that starts without anything of ours; skips where there is no such shell."""
    if shutil.which(name) is None:
        pytest.skip(f'{name} is not installed')
    clean = {key: value for key, value in os.environ.items() if key not in SAVED and not key.startswith('VIRTUAL_ENV')}
    known = {**clean, 'HOME': str(home), 'ZDOTDIR': str(home), 'PATH': '/usr/local/bin:/usr/bin:/bin', 'TERM': 'dumb', **env}
    words = [*(START[name] if not options else (name, *options)), '-c', lines]
    done = subprocess.run(words, env=known, cwd=home, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def activate(prefix: Path, name: str) -> str:
    return f"source '{prefix}/bin/activate{'.fish' if name == 'fish' else ''}'"


def printed(name: str) -> str:
    return f'env | grep -E "^({"|".join(SAVED)})=" | sort'


@pytest.mark.processes
@pytest.mark.parametrize('name', sorted(START))
def test_one_line_brings_ros_and_answers_to_set_up_lines(environment: Path, tmp_path: Path, name: str) -> None:
    said = shell(
        name, tmp_path, f'{activate(environment, name)}; source /opt/ros/jazzy/setup.bash; colcon build; {printed(name)}'
    )
    assert said[0].startswith('source: you do not need to source ROS 2 Jazzy') and said[1].startswith(
        'colcon build: edulaunch needs no'
    )
    found = dict(line.split('=', 1) for line in said[2:])
    assert found.pop('PATH').startswith(f'{environment}/bin:')
    assert found == {
        'AMENT_PREFIX_PATH': underlay_prefix(),
        'PYTHONPATH': f'{underlay_prefix()}/shell:{underlay_python()}',
        'ROS_DISTRO': 'jazzy',
        'ROS_PYTHON_VERSION': '3',
        'ROS_VERSION': '2',
    }


@pytest.mark.processes
@pytest.mark.parametrize('name', sorted(START))
def test_deactivate_takes_everything_back_after_two_activations_too(environment: Path, tmp_path: Path, name: str) -> None:
    functions = 'functions -n' if name == 'fish' else 'typeset -f'
    keeps = f'{functions} > before; {printed(name)} > env_before'
    ends = f'deactivate; {functions} > after; {printed(name)} > env_after'
    once = activate(environment, name)
    shell(name, tmp_path, f'{keeps}; {once}; {once}; {ends}', env={'PYTHONPATH': '/mine', 'ROS_PACKAGES': 'x'})
    before, after = ((tmp_path / file).read_text().replace(', ', '\n').splitlines() for file in ('before', 'after'))
    added = [line for line in after if line not in before]
    assert [line for line in added if name != 'fish' or 'edulaunch' in line or line in OURS] == []  # fish loads its own late
    assert (tmp_path / 'env_after').read_text() == (tmp_path / 'env_before').read_text()
    assert 'PYTHONPATH=/mine\n' in (tmp_path / 'env_after').read_text()


@pytest.mark.processes
@pytest.mark.parametrize('name', ['bash', 'zsh'])
def test_where_a_real_ros_is_sourced_its_paths_stay_alone(environment: Path, tmp_path: Path, name: str) -> None:
    env = {'AMENT_PREFIX_PATH': '/opt/ros/jazzy', 'PYTHONPATH': '/opt/ros/jazzy/lib', 'ROS_DISTRO': 'jazzy'}
    said = shell(name, tmp_path, f'{activate(environment, name)}; {printed(name)}; deactivate; {printed(name)}', env=env)
    assert said.count('PYTHONPATH=/opt/ros/jazzy/lib') == said.count('AMENT_PREFIX_PATH=/opt/ros/jazzy') == 2


@pytest.mark.processes
@pytest.mark.parametrize('name', sorted(START))
def test_a_new_shell_that_reads_its_settings_completes_three_commands(environment: Path, tmp_path: Path, name: str) -> None:
    settings = tmp_path / SETTINGS[name]
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text(activate(environment, name) + '\n')
    asks = {
        'bash': 'complete -p edulaunch edugrade ros2',
        'fish': "complete -C 'edugrade gradesc'; complete -C 'edulaunch laun'; complete -C 'ros2 topi'",
        'zsh': 'for name in edulaunch edugrade ros2; do echo $_comps[$name]; done',
    }
    wants = {
        'bash': [f'complete -F _edulaunch {command}' for command in ('edulaunch', 'edugrade', 'ros2')],
        'fish': ['gradescope', 'launch', 'topic'],
        'zsh': ['_edulaunch'] * 3,
    }
    assert shell(name, tmp_path, asks[name], '-i') == wants[name]


@pytest.mark.processes
def test_a_strict_script_may_activate_and_starts_no_python(environment: Path, tmp_path: Path) -> None:
    (environment / 'bin/edulaunch').write_text('#!/bin/sh\necho started >&2\nexit 9\n')
    assert shell('bash', tmp_path, f'set -eu; {activate(environment, "bash")}; deactivate; echo fine') == ['fine']
    assert shell('bash', tmp_path, f'{activate(environment, "bash")} 2>&1; echo $ROS_DISTRO') == ['jazzy']


@pytest.mark.processes
def test_installed_twice_it_is_read_once_and_without_edulaunch_not_at_all(environment: Path, tmp_path: Path) -> None:
    before = (environment / 'bin/activate').read_text()
    assert before.count('edulaunch.sh') == 1
    assert [path.name for path in install(environment)] == ['activate', 'activate.fish']
    assert (environment / 'bin/activate').read_text() == before
    (environment / 'bin/edulaunch').unlink()
    assert shell('bash', tmp_path, f'{activate(environment, "bash")}; echo "<${{ROS_DISTRO:-}}>"') == ['<>']


def test_outside_of_an_environment_install_says_how_to_make_one(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='is not a virtual environment.*\n.*python3 -m venv'):
        install(tmp_path)


def test_the_command_alone_prints_three_next_steps_and_succeeds(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    said = capsys.readouterr().out
    assert said.startswith('What would you like to do next?\n') and len(said.splitlines()) == 5

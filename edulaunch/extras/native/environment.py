"""The environment of the real rclpy: a virtual environment in the user's cache, which `edulaunch network install` creates.

The environment must be separate, because its wheels make every Python in their environment start twice. Also, a simulation
cannot share an interpreter with a real rclpy.
"""

from __future__ import annotations

import json
import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from edulaunch.errors import EdulaunchError, UnusableInput

REQUIREMENT = 'ros-jazzy-rclpy[fastrtps]'
PLACE_VARIABLE = 'EDULAUNCH_REAL_RCLPY'
MARK = 'edulaunch.json'
"""A file in a complete environment that describes its content."""
NEEDED_MB = 220
_PROBE = "import json, rclpy; from importlib.metadata import version; print(json.dumps({'rclpy': version('ros-jazzy-rclpy')}))"
_OFFLINE_SIGNS = ('Temporary failure in name resolution', 'NewConnectionError', 'Connection refused', 'Network is unreachable')
_NO_WHEEL_SIGNS = ('No matching distribution found', 'Could not find a version that satisfies')


class Environment(NamedTuple):
    """A complete installation of the real rclpy.

    :ivar place: the folder of the environment.
    :ivar version: the version of the real rclpy in the environment.
    """

    place: str
    version: str

    @property
    def python(self) -> str:
        """Return the path of the environment's Python."""
        return os.path.join(self.place, 'bin', 'python')


def place() -> str:
    """Return the folder of the environment, which may not exist yet.

    The folder is $EDULAUNCH_REAL_RCLPY or, without this variable, a folder for this version of Python in the user's cache.
    """
    given = os.environ.get(PLACE_VARIABLE)
    if given:
        return os.path.abspath(given)
    cache = os.environ.get('XDG_CACHE_HOME') or os.path.join(os.path.expanduser('~'), '.cache')
    return os.path.join(cache, 'edulaunch', f'rclpy-jazzy-python{sys.version_info[0]}.{sys.version_info[1]}')


def found() -> Environment | None:
    """Return the environment, or None if it does not exist."""
    folder = place()
    try:
        with open(os.path.join(folder, MARK), encoding='utf-8') as file:
            return Environment(folder, str(json.load(file)['rclpy']))
    except (OSError, ValueError, KeyError, TypeError):
        return None


def needed() -> Environment:
    """Return the environment. Unlike :func:`found`, raise an error if it does not exist.

    :raises UnusableInput: when there is no environment.
    """
    environment = found()
    if environment is None:
        raise UnusableInput(
            'the real rclpy is not installed.', help=unsuited() or f'type: edulaunch network install ({NEEDED_MB} MB)'
        )
    return environment


def unsuited() -> str | None:
    """Return the reason why there are no wheels for this machine, or None if there are wheels."""
    system, machine, version = platform.system(), platform.machine(), sys.version_info[:2]
    if (system, machine) != ('Linux', 'x86_64'):
        return f'its wheels are for Linux on x86-64, and this is {system} on {machine}'
    if not (3, 10) <= version <= (3, 14):
        return f'its wheels are for Python 3.10 to 3.14, and this is {version[0]}.{version[1]}'
    return None


def install(say: Callable[[str], object]) -> Environment:
    """Create the environment. If it exists, create it again.

    :param say: called with each step, one line at a time.
    :raises UnusableInput: when there are no wheels for this machine or this Python.
    :raises EdulaunchError: when the wheels could not be downloaded, or do not run.
    """
    reason = unsuited()
    if reason:
        raise UnusableInput(
            f'the real rclpy cannot be installed here: {reason}.', help='use the default link, which is in the extra network'
        )
    folder = place()
    if os.path.exists(folder) and not os.path.exists(os.path.join(folder, 'pyvenv.cfg')):
        raise UnusableInput(f'{folder} exists and is not a Python environment.', help='move it away, and try again')
    with _alone(folder):
        shutil.rmtree(folder, ignore_errors=True)
        pip = _pip()
        say(f'making {folder}')
        _run(
            [sys.executable, '-m', 'venv', *([] if pip is None else ['--without-pip']), folder],
            'the environment could not be created',
        )
        python = os.path.join(folder, 'bin', 'python')
        say(f'downloading {REQUIREMENT} ({NEEDED_MB} MB with its dependencies)')
        _fetch([*(pip or [python, '-m', 'pip']), *_pip_words(pip, python), REQUIREMENT], say)
        say('trying it')
        probed = _run([python, '-c', _PROBE], 'the real rclpy was installed, but cannot be imported')
        with open(os.path.join(folder, MARK), 'w', encoding='utf-8') as file:
            file.write(probed)
    return needed()


@contextmanager
def _alone(folder: str) -> Iterator[None]:
    """Wait until no other process installs to the same folder."""
    import fcntl

    os.makedirs(os.path.dirname(folder), exist_ok=True)
    with open(f'{folder}.lock', 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _pip() -> list[str] | None:
    """Return the command of an installer for other environments, or None if the environment needs its own pip."""
    from importlib.util import find_spec

    if find_spec('pip') is not None:
        return [sys.executable, '-m', 'pip']
    uv = shutil.which('uv')
    return None if uv is None else [uv, 'pip']


def _pip_words(pip: list[str] | None, python: str) -> list[str]:
    if pip is not None and len(pip) == 2:
        return ['install', '--python', python]
    return [*([] if pip is None else ['--python', python]), 'install', '--disable-pip-version-check', '--prefer-binary']


def _fetch(command: list[str], say: Callable[[str], object]) -> None:
    """Run an installer, and report the package that it currently processes."""
    lines: list[str] = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors='replace') as child:
        assert child.stdout is not None
        for line in child.stdout:
            lines.append(line)
            if line.startswith(('Collecting ', 'Installing ')):
                say(line.split('>=')[0].split(' (from')[0].strip()[:100])
    if child.returncode:
        raise _failure(''.join(lines))


def _failure(text: str) -> EdulaunchError:
    if any(sign in text for sign in _OFFLINE_SIGNS):
        return EdulaunchError(
            'the wheels of the real rclpy could not be downloaded: no connection.', help='connect to the internet, and try again'
        )
    if any(sign in text for sign in _NO_WHEEL_SIGNS):
        version = '.'.join(map(str, sys.version_info[:2]))
        return EdulaunchError(f'no wheel of {REQUIREMENT} fits this machine and Python {version}.', help='try Python 3.12')
    return EdulaunchError('the wheels of the real rclpy could not be installed:\n' + '\n'.join(text.splitlines()[-5:]))


def _run(command: list[str], failed: str) -> str:
    outside = dict(os.environ)
    outside.pop('PYTHONPATH', None)  # in an active terminal it leads to the simulated rclpy
    done = subprocess.run(command, capture_output=True, text=True, env=outside)
    if done.returncode:
        raise EdulaunchError(f'{failed}:\n' + '\n'.join((done.stderr or done.stdout).splitlines()[-5:]))
    return done.stdout

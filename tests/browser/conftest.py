"""JupyterLab over a copy of the course, and a browser that can reach nothing else; skipped with a reason where one is missing."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from tests.browser.desk import Desk
from tests.browser.lab import WAIT_MS, Lab, find_browser

ROOT = Path(__file__).resolve().parents[2]
START_S = 240.0
DEMO = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
GO_S = 15.0
AXE = 'axe-core@4.14.1'
NOBODY_ELSE = '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1'
"""A browser that finds no other machine, whatever a page asks for."""
OWN_FOLDERS = (
    'JUPYTER_CONFIG_DIR',
    'JUPYTER_DATA_DIR',
    'JUPYTER_RUNTIME_DIR',
    'JUPYTERLAB_SETTINGS_DIR',
    'JUPYTERLAB_WORKSPACES_DIR',
)
QUIET = ['--LabApp.news_url=None', '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate']


@pytest.fixture(scope='package')
def browser() -> Iterator[Any]:
    """Debian's Chromium without a window, driven by playwright."""
    api = pytest.importorskip('playwright.sync_api', reason='playwright is not installed: pip install ".[browser]"')
    program = find_browser()
    if program is None:
        pytest.skip('no Chromium on this machine: apt-get install chromium-headless-shell')
    with api.sync_playwright() as playwright:
        words = ['--no-sandbox', '--disable-dev-shm-usage', '--disable-gpu', NOBODY_ELSE]
        found = playwright.chromium.launch(executable_path=program, args=words)
        yield found
        found.close()


@pytest.fixture(scope='package')
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The course as a fresh clone has it: lessons, exercises and solutions, nothing of a student's."""
    place = tmp_path_factory.mktemp('course')
    for name in ('lessons', 'exercises', 'solutions'):
        shutil.copytree(ROOT / name, place / name, ignore=shutil.ignore_patterns('my_*', '.ipynb_checkpoints', '__pycache__'))
    return place


@pytest.fixture(scope='package')
def shots(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pictures of the pages go: the folder that EDULAUNCH_SCREENSHOTS names, else a temporary one."""
    place = Path(os.environ.get('EDULAUNCH_SCREENSHOTS') or tmp_path_factory.mktemp('shots'))
    place.mkdir(parents=True, exist_ok=True)
    return place


@pytest.fixture(scope='package')
def lab(browser: Any, course: Path, shots: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """A JupyterLab that serves the course, with settings of its own."""
    pytest.importorskip('jupyterlab', reason='JupyterLab is not installed')
    home = tmp_path_factory.mktemp('jupyter')
    env = {**os.environ, 'USER': 'student', **{name: str(home / name.lower()) for name in OWN_FOLDERS}}
    words = [
        'lab',
        '--no-browser',
        '--ip=127.0.0.1',
        f'--port={8900 + os.getpid() % 1000}',  # or one of the next, where that is taken
        '--allow-root',
        '--IdentityProvider.token=',
        f'--ServerApp.root_dir={course}',
        '--LabApp.expose_app_in_browser=True',
        *QUIET,
    ]
    with (home / 'log.txt').open('w') as log:
        server = subprocess.Popen([sys.executable, '-m', 'jupyter', *words], env=env, stdout=log, stderr=log)
        try:
            yield Lab(browser, _address(server, home), shots)
        finally:
            _end(server)


def _end(server: subprocess.Popen[bytes]) -> None:
    """Ask it to go; one that still waits for a kernel after that is ended."""
    server.terminate()
    try:
        server.wait(timeout=GO_S)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()


def _address(server: subprocess.Popen[bytes], home: Path) -> str:
    """Where it answers: it writes that down, as the port is the first that nobody has."""
    until = time.monotonic() + START_S
    while time.monotonic() < until and server.poll() is None:
        with suppress(OSError, ValueError, StopIteration):
            said = json.loads(next((home / 'jupyter_runtime_dir').glob('jpserver-*.json')).read_text())
            url = f'http://127.0.0.1:{said["port"]}'
            with urllib.request.urlopen(f'{url}/api/status', timeout=5):
                return url
        time.sleep(0.2)
    pytest.fail(f'JupyterLab did not start:\n{(home / "log.txt").read_text(errors="replace")[-2000:]}')


@pytest.fixture
def page(browser: Any) -> Iterator[Any]:
    context = browser.new_context(viewport={'width': 1280, 'height': 860})
    yield context.new_page()
    context.close()


@pytest.fixture
def beside_terminal(page: Any, tmp_path: Path) -> Iterator[Desk]:
    """The page of a machine of this test's own, on which the demo runs."""
    env = {**os.environ, 'XDG_RUNTIME_DIR': str(tmp_path), 'EDULAUNCH_GRACE_S': '1', 'ROS_DOMAIN_ID': '88', 'BROWSER': 'true'}
    tmp_path.chmod(0o700)
    words = [sys.executable, '-m', 'edulaunch']
    quiet = {'stdout': subprocess.PIPE, 'stderr': subprocess.DEVNULL, 'env': env, 'text': True}
    launch = subprocess.Popen([*words, 'ros2', 'launch', *DEMO], **quiet)  # type: ignore[call-overload]
    view = subprocess.Popen([*words, 'view', '--no-browser'], **quiet)  # type: ignore[call-overload]
    address = re.search(r'http://\S+', view.stdout.readline())
    assert address
    desk = Desk(page, (address[0], address[0].replace('http', 'ws'), 'blob:'))
    desk.processes, desk.address, desk.env = {'launch': launch, 'view': view}, address[0], env
    page.goto(address[0])
    page.locator('.worlds canvas').first.wait_for()
    yield desk
    for process in desk.processes.values():
        process.terminate()
        process.wait(timeout=WAIT_MS / 1000)
        process.stdout.close()


@pytest.fixture(scope='package')
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The text of axe-core: from the file that EDULAUNCH_AXE names, else from npm."""
    if 'EDULAUNCH_AXE' in os.environ:
        return Path(os.environ['EDULAUNCH_AXE']).read_text(encoding='utf-8')
    npm = shutil.which('npm')
    if npm is None:
        pytest.skip('no npm: set EDULAUNCH_AXE to the path of axe.min.js')
    folder = tmp_path_factory.mktemp('axe')
    done = subprocess.run([npm, 'pack', AXE], cwd=folder, capture_output=True, check=False, timeout=120)
    if done.returncode:
        pytest.skip('axe-core cannot be had from npm: set EDULAUNCH_AXE to the path of axe.min.js')
    with tarfile.open(next(folder.glob('*.tgz'))) as packed:
        member = packed.extractfile('package/axe.min.js')
        assert member is not None
        return member.read().decode()

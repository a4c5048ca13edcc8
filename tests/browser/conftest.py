"""JupyterLab and a browser for the lessons; skipped with a reason where one of them is missing.

Written anew from its use in `lab.py` and `test_lessons.py`, after the first version was lost.
"""
from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.browser.lab import Lab

ROOT = Path(__file__).resolve().parents[2]
START_S = 60.0


@pytest.fixture(scope='module')
def browser() -> Iterator[Any]:
    """A headless Chromium."""
    api = pytest.importorskip('playwright.sync_api', reason='playwright is not installed: pip install "edulaunch[browser]"')
    program = shutil.which('chromium') or shutil.which('chromium-browser')
    if program is None:
        pytest.skip('no Chromium on this machine: apt-get install chromium')
    with api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=['--no-sandbox', '--disable-dev-shm-usage'])
        yield browser
        browser.close()


@pytest.fixture(scope='module')
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the course, as a student has it."""
    place = tmp_path_factory.mktemp('course')
    for name in ('lessons', 'exercises', 'solutions'):
        shutil.copytree(ROOT / name, place / name)
    return place


@pytest.fixture(scope='module')
def lab(browser: Any, course: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """A JupyterLab that serves the course, with settings of its own."""
    pytest.importorskip('jupyterlab', reason='JupyterLab is not installed')
    with socket.socket() as free:
        free.bind(('127.0.0.1', 0))
        port = free.getsockname()[1]
    home = tmp_path_factory.mktemp('jupyter')
    folders = ('JUPYTER_CONFIG_DIR', 'JUPYTER_DATA_DIR', 'JUPYTER_RUNTIME_DIR', 'JUPYTERLAB_SETTINGS_DIR', 'JUPYTERLAB_WORKSPACES_DIR')
    paths = os.pathsep.join(filter(None, [str(ROOT), str(ROOT / 'grader'), os.environ.get('PYTHONPATH', '')]))
    env = {**os.environ, 'PYTHONPATH': paths, 'USER': 'student', **{name: str(home / name.lower()) for name in folders}}
    words = ['lab', '--no-browser', '--ip=127.0.0.1', f'--port={port}', '--ServerApp.port_retries=0', '--allow-root',
             '--IdentityProvider.token=', f'--ServerApp.root_dir={course}', '--LabApp.expose_app_in_browser=True']
    url = f'http://127.0.0.1:{port}'
    with (home / 'log.txt').open('w') as log:
        server = subprocess.Popen([sys.executable, '-m', 'jupyter', *words], env=env, stdout=log, stderr=log)
        try:
            _wait_for(url, server)
            yield Lab(browser, url, tmp_path_factory.mktemp('shots'))
        finally:
            server.terminate()
            server.wait(timeout=20)


def _wait_for(url: str, server: subprocess.Popen[bytes]) -> None:
    until = time.monotonic() + START_S
    while time.monotonic() < until and server.poll() is None:
        try:
            with urllib.request.urlopen(f'{url}/api/status', timeout=5):
                return
        except (urllib.error.URLError, ConnectionError):
            time.sleep(0.2)
    pytest.fail('JupyterLab did not start')

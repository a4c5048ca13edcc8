"""Make the pictures of a lesson, a report, a class page and a run for docs/gallery.md: `python -m tests.browser.gallery [FOLDER]`.

It grades a small class that it makes from our solution and starter file, runs a lesson in JupyterLab, and takes pictures in Chromium.
Run it when one of these pages has changed, look at the pictures, and commit them.
"""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from tests.browser.lab import ALL_RAN, OPEN, RUN_ALL, STARTED, find_browser

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / 'docs' / 'pictures'
SIZE = {'width': 1100, 'height': 820}
LESSON = 'lessons/01_first_launch.ipynb'
THEMES = {'light': 'JupyterLab Light', 'dark': 'JupyterLab Dark'}
CHANGES = {
    'Ada': ('', ''),
    'Ben': ('circle_radius', 'circle_radus'),
    'Cleo': ("default_value='1.0'", "default_value='2.0'"),
    'Dora': ("'radius'", "'radus'"),
}
"""What each student changed in the solution; Emil hands in the starter file, and Fay nothing that can be read."""
QUIET = ('--LabApp.news_url=None', '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate')
SCROLL = """async () => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  const index = notebook.widgets.findIndex(cell => cell.model.id === 'multisim-picture');
  notebook.activeCellIndex = index;
  await notebook.scrollToItem(index, 'center');
}"""


def graded(folder: Path) -> Path:
    """Grade a class of six and the starter file; return the folder with `class/index.html` and `report.html`."""
    solution, starter = (ROOT / name / 'circle.launch.py' for name in ('solutions', 'exercises'))
    texts = {name: solution.read_text('utf-8').replace(*change) for name, change in CHANGES.items()}
    texts |= {'Emil': starter.read_text('utf-8'), 'Fay': 'def generate_launch_description(:\n'}
    for name, text in texts.items():
        (folder / 'submissions' / name).mkdir(parents=True)
        (folder / 'submissions' / name / 'circle.launch.py').write_text(text, 'utf-8')
    grade = [sys.executable, '-m', 'edugrade']
    quiet: dict[str, Any] = {'stdout': subprocess.DEVNULL, 'stderr': subprocess.DEVNULL, 'cwd': folder}
    subprocess.run([*grade, 'batch', 'submissions', '--html', 'class', '--sandbox', 'auto'], **quiet, check=False)
    subprocess.run([*grade, 'submissions/Dora/circle.launch.py', '--html', 'report.html'], **quiet, check=False)
    return folder


def shoot_pages(browser: Any, folder: Path, place: Path) -> None:
    """Take pictures of the report and of the class page."""
    context = browser.new_context(viewport=SIZE)
    page = context.new_page()
    for name, file in (('report', place / 'report.html'), ('class', place / 'class' / 'index.html')):
        page.goto(file.as_uri())
        page.screenshot(path=folder / f'{name}.png')
    context.close()


@contextmanager
def jupyter(folder: Path) -> Iterator[str]:
    """A JupyterLab that serves a copy of the course; gives its address."""
    for name in ('lessons', 'exercises'):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns('my_*', '.*', '__pycache__'))
    settings = folder / '.lab' / '@jupyterlab' / 'apputils-extension' / 'notification.jupyterlab-settings'
    settings.parent.mkdir(parents=True)
    settings.write_text('{"fetchNews": "false", "checkForUpdates": false}')
    with socket.socket() as free:
        free.bind(('127.0.0.1', 0))
        port = free.getsockname()[1]
    env = {
        **os.environ,
        'USER': 'student',
        'JUPYTER_CONFIG_DIR': str(folder / '.config'),
        'JUPYTERLAB_SETTINGS_DIR': str(folder / '.lab'),
    }
    words = [
        'lab',
        '--no-browser',
        '--allow-root',
        f'--port={port}',
        '--IdentityProvider.token=',
        f'--ServerApp.root_dir={folder}',
    ]
    words += ['--LabApp.expose_app_in_browser=True', *QUIET]
    quiet: dict[str, Any] = {'stdout': subprocess.DEVNULL, 'stderr': subprocess.DEVNULL}
    server = subprocess.Popen([sys.executable, '-m', 'jupyter', *words], env=env, **quiet)
    try:
        until = time.monotonic() + 90
        while time.monotonic() < until:
            with suppress(OSError), urllib.request.urlopen(f'http://127.0.0.1:{port}/api/status', timeout=5):
                break
            time.sleep(0.2)
        yield f'http://127.0.0.1:{port}'
    finally:
        server.terminate()
        server.wait(timeout=60)


def shoot_lesson(browser: Any, folder: Path, address: str) -> None:
    """Run the first lesson, and take its first picture in both themes."""
    context = browser.new_context(viewport=SIZE)
    context.set_default_timeout(240_000)
    page = context.new_page()
    page.goto(f'{address}/lab?reset')
    page.wait_for_function(STARTED, polling=100)
    page.evaluate("() => window.jupyterapp.commands.execute('application:toggle-left-area')")
    page.evaluate(OPEN, LESSON)
    page.get_by_text('Python 3 (ipykernel) | Idle').wait_for()
    page.evaluate(RUN_ALL)
    page.wait_for_function(ALL_RAN, polling=500)
    for scheme, theme in THEMES.items():
        page.evaluate("theme => window.jupyterapp.commands.execute('apputils:change-theme', {theme})", theme)
        page.wait_for_timeout(2000)
        page.evaluate(SCROLL)
        page.wait_for_timeout(1000)
        page.screenshot(path=folder / f'lesson_{scheme}.png')
    page.evaluate('() => window.jupyterapp.serviceManager.sessions.shutdownAll()')
    context.close()


def draw_run(folder: Path) -> None:
    """Draw the run of the README's ten lines."""
    import edulaunch

    recording = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=12, seed=0)
    recording.plot_turtles().save(folder / 'turtles.png')
    recording.plot_frames().save(folder / 'frames.png')


def main(folder: Path = FOLDER) -> None:
    """Make all pictures."""
    from playwright.sync_api import sync_playwright

    program = find_browser()
    assert program, 'install Chromium first: apt-get install chromium'
    folder.mkdir(parents=True, exist_ok=True)
    draw_run(folder)
    with tempfile.TemporaryDirectory() as place, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=['--no-sandbox', '--disable-dev-shm-usage'])
        shoot_pages(browser, folder, graded(Path(place)))
        with jupyter(Path(place)) as address:
            shoot_lesson(browser, folder, address)
        browser.close()


if __name__ == '__main__':
    main(*map(Path, sys.argv[1:]))

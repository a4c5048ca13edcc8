"""Make the pictures of README.md and docs/ from the real live view: `python -m tests.browser.pictures [FOLDER]`.

It starts a machine of its own, launches the tf2 demo, drives with the arrow keys in Chromium, and photographs the page. Run it when the page
has changed, look at the pictures, and commit them.
"""

from __future__ import annotations

import io
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from PIL import Image

from tests.browser.desk import Desk
from tests.browser.lab import find_browser

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / 'docs' / 'pictures'
DEMO = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
MISSPELT = ('topic', 'pub', '--times', '3', '-w', '0', '/turtle1/cmd_val', 'geometry_msgs/msg/Twist', '{linear: {x: 1.0}}')
SIZE = {'width': 1120, 'height': 640}
SHOWN = (896, 512)
FRAME_MS = 100


@contextmanager
def live_view(browser: Any, scheme: str) -> Iterator[Desk]:
    """The live view of a new machine on which the tf2 demo runs."""
    with tempfile.TemporaryDirectory() as place:
        env = {**os.environ, 'XDG_RUNTIME_DIR': place, 'EDULAUNCH_GRACE_S': '1', 'ROS_DOMAIN_ID': '87', 'BROWSER': 'true'}
        words = [sys.executable, '-m', 'edulaunch']
        quiet: dict[str, Any] = {'stdout': subprocess.PIPE, 'stderr': subprocess.DEVNULL, 'env': env, 'text': True}
        launch = subprocess.Popen([*words, 'ros2', 'launch', *DEMO], **quiet)
        view = subprocess.Popen([*words, 'view', '--no-browser'], **quiet)
        context = browser.new_context(viewport=SIZE, color_scheme=scheme)
        try:
            address = re.search(r'http://\S+', view.stdout.readline())
            assert address, 'the live view printed no address'
            desk = Desk(context.new_page())
            desk.env = env
            desk.page.goto(address[0])
            desk.page.locator('.worlds canvas').first.wait_for()
            desk.until_js("root.querySelector('.worlds canvas').ariaLabel.includes('turtle2')")
            yield desk
        finally:
            context.close()
            for process in (launch, view):
                process.terminate()
                process.wait(timeout=20)
                process.stdout.close()


def timeline(desk: Desk) -> list[Image.Image]:
    """Drive a curve, show the graph, and let the live view report a misspelt topic."""
    page, frames = desk.page, []

    def shoot(count: int) -> None:
        frames.extend(Image.open(io.BytesIO(page.screenshot())) for _ in range(count))

    page.locator('.worlds canvas').first.click()
    shoot(4)
    for key in ('ArrowUp', 'ArrowLeft', 'ArrowUp', 'ArrowUp', 'ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowUp'):
        page.keyboard.press(key)
        shoot(4)
    desk.open('graph')
    for key in ('ArrowLeft', 'ArrowUp', 'ArrowUp'):
        page.locator('.worlds canvas').first.click()
        page.keyboard.press(key)
        shoot(4)
    subprocess.run([sys.executable, '-m', 'edulaunch', 'ros2', *MISSPELT], env=desk.env, stdout=subprocess.DEVNULL, check=True)
    page.get_by_text('Look for mistakes').click()
    page.locator('summary', has_text='⚠').click()
    desk.until('.desk', 'cmd_val')
    shoot(14)
    return frames


def save(frames: list[Image.Image], path: Path) -> None:
    """Write an animated picture with one palette for all frames, so that unchanged parts cost nothing."""
    small = [frame.convert('RGB').resize(SHOWN, Image.Resampling.LANCZOS) for frame in frames]
    palette = small[len(small) // 2].quantize(96)
    shown = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in small]
    shown[0].save(path, save_all=True, append_images=shown[1:], duration=FRAME_MS, loop=0, optimize=True)


def main(folder: Path = FOLDER) -> None:
    """Make all pictures."""
    from playwright.sync_api import sync_playwright

    program = find_browser()
    assert program, 'install Chromium first: apt-get install chromium'
    folder.mkdir(parents=True, exist_ok=True)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=['--no-sandbox', '--disable-dev-shm-usage'])
        with live_view(browser, 'light') as desk:
            save(timeline(desk), folder / 'live_view.gif')
        for scheme in ('light', 'dark'):
            with live_view(browser, scheme) as desk:
                desk.page.locator('.worlds canvas').first.click()
                for key in ('ArrowUp', 'ArrowLeft', 'ArrowUp'):
                    desk.page.keyboard.press(key)
                    desk.page.wait_for_timeout(300)
                desk.open('frames')
                desk.page.screenshot(path=folder / f'live_view_{scheme}.png')
        browser.close()


if __name__ == '__main__':
    main(*map(Path, sys.argv[1:]))

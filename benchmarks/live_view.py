"""The live desk in a browser: pictures a second, and how long going back takes, beside a bare loop that draws nothing.

Needs `edulaunch[browser]` and Chromium. Films are made by hand, so that a hundred turtles need no simulation.
"""

from __future__ import annotations

import math
import shutil
import tempfile
from pathlib import Path
from typing import Any

from edulaunch.view.columns import FINE, number_steps
from edulaunch.view.page import recorded_page

ARGUMENTS = ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage']
COUNT = """(draw) => new Promise(done => {
  let frames = 0; const began = performance.now();
  const beat = () => { if (draw) window.desk.redraw(); frames++; const passed = performance.now() - began;
    if (passed < 2000) requestAnimationFrame(beat); else done(frames / passed * 1000); };
  requestAnimationFrame(beat); })"""
SEEK = """() => { const desk = window.desk, found = [];
  for (let i = 1; i <= 20; i++) { desk.time = desk.store.now * ((i * 7) % 20) / 20; const began = performance.now();
    desk.asked = true; desk.beat(began); found.push(performance.now() - began); }
  desk.asked = false; return found.sort((a, b) => a - b)[10]; }"""


def film(turtles: int, frames: int, seconds: float, rate: float = 62.5) -> dict[str, Any]:
    """A film of turtles on circles, with so many tf frames beside them."""
    count = int(seconds * rate)
    times = number_steps([i * 1_000_000 / rate for i in range(count)], 1)[0]
    piece: dict[str, Any] = {
        'start': 0,
        'now': int(seconds * 1e6),
        'topics': [],
        'tf': [],
        'nodes': [[0, '/sim', 'sim-1', 1, 0, None]],
    }
    piece['endpoints'] = []
    for number in range(turtles):
        turn = [i / rate * 0.7 + number for i in range(count)]
        columns = [[5.5 + 4 * math.cos(a) * (1 - number / 200) for a in turn], [5.5 + 4 * math.sin(a) for a in turn], turn]
        name = f'/turtle{number + 1}/pose'
        fields = [['x', 'float'], ['y', 'float'], ['theta', 'float']]
        steps = [number_steps(column, FINE)[0] for column in columns]
        piece['topics'].append({'name': name, 'type': 'turtlesim/msg/Pose', 't': times, 'fields': fields, 'c': steps})
        piece['endpoints'].append([0, 'publisher', name, 'turtlesim/msg/Pose', 1, 10 + number, [10, 'reliable', 'volatile']])
    for number in range(frames):
        x = number_steps([5 + number / 40 + math.sin(i / 30) for i in range(count)], FINE)[0]
        still = [[count]] if count > 2 else [0] * count
        parent = f'frame{number - 1}' if number % 10 else 'world'
        columns = [times, times, x, x, still, still, still, still, [100 * FINE, *still[1:], [count - 1]]]
        piece['tf'].append({'child': f'frame{number}', 'parent': parent, 'by': 10, 'static': False, 'c': columns})
    return piece


def main() -> None:
    """Print the figures."""
    from playwright.sync_api import sync_playwright

    program = shutil.which('chromium') or shutil.which('chromium-browser')
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=program, args=ARGUMENTS)
        page = browser.new_page(viewport={'width': 1280, 'height': 860})
        for title, piece in (
            ('3 turtles, 12 frames, 60 s', film(3, 12, 60)),
            ('100 turtles, 200 frames, 20 s', film(100, 200, 20)),
            ('3 turtles, 12 frames, 10 minutes', film(3, 12, 600)),
        ):
            file = Path(folder) / 'film.html'
            file.write_text(recorded_page(piece, title, 'frames').replace('.load(film)', '.load(film, window)'), encoding='utf-8')
            page.goto(file.as_uri())
            page.wait_for_function('() => window.desk && window.desk.worldViews')
            bare = page.evaluate(COUNT, False)
            page.evaluate('() => { window.desk.playing = true; window.desk.redraw(); }')
            drawn = page.evaluate(COUNT, True)
            page.evaluate('() => { window.desk.playing = false; }')
            took = page.evaluate(SEEK)
            print(f'{title}: {drawn:.0f} pictures a second (a bare loop {bare:.0f}), an instant shown in {took:.1f} ms')
        browser.close()


if __name__ == '__main__':
    main()

"""The live desk in a browser: pictures a second, and how long going back takes, beside a bare loop that draws nothing.

Needs `pip install '.[browser]'` and Chromium. Films are made by hand, so that a hundred turtles need no simulation.
"""

from __future__ import annotations

import asyncio
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import edulaunch
from edulaunch.desk.view.columns import FINE, number_steps
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import RecorderSource
from edulaunch.desk.view.timeline import Timeline
from edulaunch.desk.view.viewer import Viewer
from tests.browser.lab import find_browser

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


COLUMNS = """() => { const { topics, tracks } = window.desk.store;
  const of = [...topics.values()].flatMap(topic => [topic.t, ...topic.columns]);
  const all = of.concat([...tracks.values()].flatMap(track => track.c));
  return all.reduce((sum, column) => sum + (column.a?.byteLength || 0), 0); }"""
"""Bytes of the columns, which the heap of scripts does not count."""


def timeline(turtles: int, frames: int, seconds: float, rate: float = 62.5) -> dict[str, Any]:
    """A timeline of turtles on circles, with so many tf frames beside them."""
    count = int(seconds * rate)
    times = number_steps([i * 1_000_000 / rate for i in range(count)], 1)[0]
    delta: dict[str, Any] = {
        'start': 0,
        'now': int(seconds * 1e6),
        'topics': [],
        'tf': [],
        'nodes': [[0, '/sim', 'sim-1', 1, 0, None]],
    }
    delta['endpoints'] = []
    for number in range(turtles):
        turn = [i / rate * 0.7 + number for i in range(count)]
        columns = [[5.5 + 4 * math.cos(a) * (1 - number / 200) for a in turn], [5.5 + 4 * math.sin(a) for a in turn], turn]
        name = f'/turtle{number + 1}/pose'
        fields = [['x', 'float'], ['y', 'float'], ['theta', 'float']]
        steps = [number_steps(column, FINE)[0] for column in columns]
        delta['topics'].append({'name': name, 'type': 'turtlesim/msg/Pose', 't': times, 'fields': fields, 'c': steps})
        delta['endpoints'].append([0, 'publisher', name, 'turtlesim/msg/Pose', 1, 10 + number, [10, 'reliable', 'volatile']])
    for number in range(frames):
        x = number_steps([5 + number / 40 + math.sin(i / 30) for i in range(count)], FINE)[0]
        still = [[count]] if count > 2 else [0] * count
        parent = f'frame{number - 1}' if number % 10 else 'world'
        columns = [times, times, x, x, still, still, still, still, [100 * FINE, *still[1:], [count - 1]]]
        delta['tf'].append({'child': f'frame{number}', 'parent': parent, 'by': 10, 'static': False, 'c': columns})
    return delta


def pictures(page: Any, folder: Path) -> None:
    """Pictures a second while a timeline plays, beside a bare loop; and how long an instant takes to be shown."""
    for title, delta, tab in (
        ('3 turtles, 12 frames, 60 s, frames open', timeline(3, 12, 60), 'frames'),
        ('3 turtles, 12 frames, 60 s, graph lit', timeline(3, 12, 60), 'graph'),
        ('100 turtles, 200 frames, 20 s', timeline(100, 200, 20), 'frames'),
        ('3 turtles, 12 frames, 10 minutes', timeline(3, 12, 600), 'frames'),
    ):
        file = folder / 'timeline.html'
        file.write_text(recorded_page(delta, title, tab).replace('.load(all)', '.load(all, window)'), encoding='utf-8')
        page.goto(file.as_uri())
        page.wait_for_function('() => window.desk && window.desk.worldViews')
        bare = page.evaluate(COUNT, False)
        page.evaluate('() => { window.desk.playing = true; window.desk.redraw(); }')
        drawn = page.evaluate(COUNT, True)
        page.evaluate('() => { window.desk.playing = false; }')
        took = page.evaluate(SEEK)
        print(f'{title}: {drawn:.0f} pictures a second (a bare loop {bare:.0f}), an instant shown in {took:.1f} ms')


DEMO = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')


def python_side(seconds: float) -> None:
    """Processor time of a machine in real time, alone and with a page that is told thirty times a second."""
    for looked_at in (False, True):

        async def body(looked_at: bool = looked_at) -> float:
            with edulaunch.start(*DEMO) as machine:
                viewer = Viewer(machine, lambda message: json.dumps(message, separators=(',', ':')))
                machine.take({'op': 'drive', 'turtle': '/turtle1', 'linear': 2, 'angular': 1})
                await asyncio.sleep(2)
                begun, before = time.monotonic(), time.process_time()
                while time.monotonic() - begun < seconds:
                    if looked_at:
                        viewer.show()
                    await asyncio.sleep(1 / 30)
                return (time.process_time() - before) / (time.monotonic() - begun)

        part = asyncio.run(body())
        print(f'python side, {"with a page" if looked_at else "alone"}: {part:.1%} of a core in real time')


def first_picture(page: Any) -> None:
    """From the call of `edulaunch view` to the first turtle on the page, while a launch runs; beside a bare Python."""
    with tempfile.TemporaryDirectory() as runtime:
        env = {**os.environ, 'XDG_RUNTIME_DIR': runtime, 'EDULAUNCH_GRACE_S': '1', 'BROWSER': 'true'}
        words = [sys.executable, '-m', 'edulaunch']
        quiet: dict[str, Any] = {'stdout': subprocess.PIPE, 'stderr': subprocess.DEVNULL, 'env': env, 'text': True}
        launch = subprocess.Popen([*words, 'ros2', 'launch', *DEMO], **quiet)
        for line in launch.stdout or ():
            if 'Spawning turtle [turtle1]' in line:
                break
        begun = time.monotonic()
        subprocess.run([sys.executable, '-c', 'import asyncio, tornado.web'], check=True)
        bare = time.monotonic() - begun
        begun = time.monotonic()
        view = subprocess.Popen([*words, 'view', '--no-browser'], **quiet)
        address = (view.stdout.readline() if view.stdout else '').split()[-1]
        served = time.monotonic() - begun
        page.goto(address)
        page.locator('.worlds canvas').first.wait_for()
        shown = time.monotonic() - begun
        print(
            f'first picture: {shown:.2f} s after the call, served after {served:.2f} s (a bare Python with tornado: {bare:.2f} s)'
        )
        for process in (view, launch):
            process.terminate()
            process.wait()


def soak(page: Any, folder: Path, minutes: int) -> None:
    """Memory of both sides while simulated hours pass as fast as they go, with the page told of each second."""
    file = folder / 'soak.html'
    script = recorded_page({'start': 0, 'now': 0}, 'soak', 'graph').replace('.load(all)', '.load(all, window)')
    file.write_text(script, encoding='utf-8')
    page.goto(file.as_uri())
    page.wait_for_function('() => window.desk')
    page.evaluate('() => { window.desk.store.grows = true; window.desk.live = window.desk.follow = true; }')
    memory = page.context.new_cdp_session(page)
    words = [sys.executable, __file__, '--machine', str(minutes)]
    held: list[tuple[int, float, float]] = []
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as machine:
        begun = time.monotonic()
        for minute in range(1, minutes + 1):
            for _ in range(60):
                line = machine.stdout.readline() if machine.stdout else ''
                page.evaluate('line => window.desk.hear({ delta: JSON.parse(line) })', line)
            if minute % 10 == 0:
                memory.send('HeapProfiler.collectGarbage')
                heap = (memory.send('Runtime.getHeapUsage')['usedSize'] + page.evaluate(COLUMNS)) / 1e6
                rss = int(Path(f'/proc/{machine.pid}/statm').read_text().split()[1]) * 4096 / 1e6
                held.append((minute, rss, heap))
                page.wait_for_timeout(100)
                shown = page.evaluate('() => [window.desk.store.from, window.desk.store.now, window.desk.state.textContent]')
                print(
                    f'{minute} simulated minutes, {time.monotonic() - begun:.0f} s: python {rss:.0f} MB, page {heap:.0f} MB, '
                    f'shown from {shown[0]:.0f} to {shown[1]:.0f} s, the page says {shown[2]!r}'
                )
    if len(held) > 2:  # the first ten minutes fill what is kept; what grows after them grows for ever
        (first, *before), (last, *after) = held[1], held[-1]
        python, tab = ((late - early) / (last - first) * 60 for early, late in zip(before, after, strict=True))
        print(f'growth from minute {first} to {last}: python {python:+.1f} MB an hour, page {tab:+.1f} MB an hour')


def machine_of_the_soak(minutes: int) -> None:
    """A machine that runs as fast as it goes, and prints a timeline delta for each simulated second."""
    with edulaunch.start(*DEMO) as machine:
        told = Timeline(RecorderSource(machine.session.recorder))
        for second in range(60 * minutes):
            if second % 30 == 0:
                machine.take({'op': 'drive', 'turtle': '/turtle1', 'linear': 2, 'angular': (-1) ** (second // 30)})
            machine.session.run(1)
            machine.forget()
            print(json.dumps(told.delta(), separators=(',', ':')), flush=True)


def main() -> None:
    """Print the figures; with a number behind it a soak of so many simulated minutes, too."""
    if sys.argv[1:2] == ['--machine']:
        machine_of_the_soak(int(sys.argv[2]))
        return
    from playwright.sync_api import sync_playwright

    program = find_browser()
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=program, args=ARGUMENTS)
        page = browser.new_page(viewport={'width': 1280, 'height': 860})
        pictures(page, Path(folder))
        first_picture(browser.new_page())
        if sys.argv[1:]:
            soak(browser.new_page(), Path(folder), int(sys.argv[1]))
        browser.close()
    python_side(10)


if __name__ == '__main__':
    main()

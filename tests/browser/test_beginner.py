"""A beginner's session in JupyterLab: three mistakes while typing, their cures, the launch step by step, and the follower."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from tests.browser.desk import Desk
from tests.browser.lab import Lab
from tests.browser.student import EDIT, SOURCE
from tests.browser.test_editor import marked, message, picture
from tests.extras.editor.test_server import LINES

pytestmark = pytest.mark.browser
CURES = {
    1: ('turtlesim_nod', "write 'turtlesim_node'"),
    3: ('nmae=', 'write name='),
    5: ('turtle_tf2_listener', 'write a comma between the two values'),
}
"""By the number of the typed line: a word that is underlined then, and the cure in its message."""
RIGHT = (
    ("'turtlesim_nod'", "'turtlesim_node'"),
    ('nmae=', 'name='),
    ("'target_frame': 'turtle1'}])\n", "'target_frame': 'turtle1'}]),\n"),
)
LOOK = "import edulaunch\nmachine = edulaunch.start('follow.launch.py', step=True)\nmachine.view('launch')"


def typed(page: Any, text: str) -> None:
    """Write the first cell as a student does who has typed this much of it."""
    page.evaluate(EDIT, 0)
    page.keyboard.press('Control+A')
    page.keyboard.insert_text(text)
    assert page.evaluate(SOURCE, 0) == text


def test_a_beginner_mends_three_mistakes_and_sees_the_follower(lab: Lab, course: Path, shots: Path) -> None:
    cells = [
        {'cell_type': 'code', 'id': name, 'metadata': {}, 'execution_count': None, 'outputs': [], 'source': source}
        for name, source in (('write', ''), ('look', LOOK))
    ]
    spec = {
        'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'},
        'language_info': {'name': 'python'},
    }
    notebook = {'nbformat': 4, 'nbformat_minor': 5, 'metadata': spec, 'cells': cells}
    (course / 'lessons' / 'beginner.ipynb').write_text(json.dumps(notebook), encoding='utf-8')
    with lab.open('beginner') as opened:
        page, text = opened.page, '%%writefile follow.launch.py\n'
        for number, line in enumerate(LINES):
            text += line
            typed(page, text if text.endswith('])\n') and text.count('[') == text.count(']') else text + '    ])\n')
            if number in CURES:
                word, cure = CURES[number]
                marked(page, [word])
                assert cure in message(page, word)
                picture(page, shots, f'beginner-{number}')
        for wrong, right in RIGHT:
            text = text.replace(wrong, right)
            typed(page, text)
        page.wait_for_function("() => !document.querySelector('.cm-lintRange')", polling=500)
        desk = Desk(page)
        page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until('.where', 'Before: Node turtlesim_node')
        seen = []
        while not seen or 'draw_square' not in seen[-1]:
            desk.press('to the next action, also')
            page.wait_for_function(
                "before => [...document.querySelectorAll('*')].find(one => one.shadowRoot?.querySelector('.where'))"
                ".shadowRoot.querySelector('.where').textContent !== before",
                arg=seen[-1] if seen else 'Before: Node turtlesim_node',
            )
            seen.append(page.locator('.where').inner_text())
            assert len(seen) < 12, seen
        picture(page, shots, 'beginner-steps')
        desk.press('play or pause')
        desk.until_js("root.querySelector('.worlds canvas')?.ariaLabel.includes('turtle2')")
        first = desk.pose('turtle2')
        desk.until_js(
            '(label => { const at = /turtle2 at .(-?[0-9.]+), (-?[0-9.]+)/.exec(label);'
            f" return at && Math.hypot(at[1] - {first[0]}, at[2] - {first[1]}) > 1; }})(root.querySelector('.worlds canvas').ariaLabel)"
        )
        assert math.dist(desk.pose('turtle2'), first) > 0.9
        page.screenshot(path=shots / 'beginner-follower.png')

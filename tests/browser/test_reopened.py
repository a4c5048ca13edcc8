"""A lesson that a student saved and opens again, before any cell has run: answers, explanations and replays are
still there, in both themes.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.browser.gallery import THEMES
from tests.browser.lab import Lab

pytestmark = pytest.mark.browser
CELLS = {
    'quiz': "from edulaunch.course import compare, explain, predict, quiz\nquiz('relative-name', 'a')",
    'explain': "explain('called-too-early', 'tell returns None and the clock calls it')",
    'predict': "predict('late', 'yes')",
    'compare': "compare('late', 'no')",
    'replay': "import edulaunch\nedulaunch.run('turtlesim', 'multisim.launch.py', duration_s=1).replay()",
}
SHOWN = {
    'quiz': ('a) /hall/chatter (your answer)', 'Not quite.'),
    'explain': ('You wrote: tell returns None', 'Answer: '),
    'predict': ('Stored: yes',),
    'compare': ('You predicted yes, the result is no',),
}
SAVE = "() => window.jupyterapp.commands.execute('docmanager:save')"
THEME = "theme => window.jupyterapp.commands.execute('apputils:change-theme', {theme})"
FAINT = """() => {
  const light = colour => {
    const [r, g, b] = colour.match(/[0-9.]+/g).slice(0, 3).map(Number).map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = one => { for (; one; one = one.parentElement) {
    const colour = getComputedStyle(one).backgroundColor;
    if (!/, 0\\)$/.test(colour) && colour !== 'transparent') return colour;
  } return 'rgb(255, 255, 255)'; };
  return [...document.querySelectorAll('.jp-OutputArea-output p')].filter(one => {
    const [a, b] = [light(getComputedStyle(one).color), light(behind(one))].sort((x, y) => y - x);
    return (a + 0.05) / (b + 0.05) < 4.5;
  }).map(one => one.textContent);
}"""


@pytest.fixture(scope='module')
def saved(lab: Lab, course: Path) -> str:
    """The name of a notebook whose cells ran, and that was saved and closed."""
    cells = [
        {'cell_type': 'code', 'id': name, 'metadata': {}, 'execution_count': None, 'outputs': [], 'source': source}
        for name, source in CELLS.items()
    ]
    spec = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'nbformat': 4, 'nbformat_minor': 5, 'metadata': spec, 'cells': cells}
    (course / 'lessons' / 'saved.ipynb').write_text(json.dumps(notebook), encoding='utf-8')
    with lab.open('saved') as opened:
        opened.run_all()
        opened.page.evaluate(SAVE)
    return 'saved'


@pytest.mark.parametrize('scheme', THEMES)
def test_a_saved_notebook_shows_answers_explanations_and_replays(lab: Lab, shots: Path, saved: str, scheme: str) -> None:
    with lab.open(saved) as opened:
        page = opened.page
        page.evaluate(THEME, THEMES[scheme])
        page.wait_for_function(f"() => document.body.dataset.jpThemeLight === '{str(scheme == 'light').lower()}'")
        for name, texts in SHOWN.items():
            opened.show(name)
            for text in texts:
                page.locator('.jp-OutputArea').get_by_text(text).first.wait_for()
        assert page.evaluate(FAINT) == []
        opened.show('replay')
        page.frame_locator('.jp-OutputArea iframe').locator('.worlds canvas').first.wait_for()
        assert 'displaying widget' not in page.locator('.jp-Notebook').inner_text()
        page.screenshot(path=shots / f'reopened-{scheme}.png')

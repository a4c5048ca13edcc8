"""Each item of the live view and of a plan is used in JupyterLab: in both themes, in narrow and wide windows."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.browser.desk import Desk
from tests.browser.lab import Lab, write_notebook

pytestmark = pytest.mark.browser
VIEW = """import edulaunch
machine = edulaunch.start('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
machine.view('plot')"""
PLANS = """first, second = (
    edulaunch.explain('turtle_tf2_py', 'turtle_tf2_demo.launch.py', arguments={'target_frame': frame})
    for frame in ('turtle1', 'carrot1')
)"""
CELLS = {'view': VIEW, 'plans': PLANS, 'graph': 'first.graph()', 'tree': 'first', 'two': 'first.compare(second).graph()'}
OUTPUT_FITS = """index => { const cell = window.jupyterapp.shell.currentWidget.content.widgets[index].node;
  const area = cell.querySelector('.jp-OutputArea'); const image = area.querySelector('img');
  return [area.scrollWidth - area.clientWidth, image === null ? '' : image.alt, image === null || image.complete]; }"""
LOOKS = [('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)]


def test_each_item_in_both_themes_and_at_two_widths(lab: Lab, course: Path, shots: Path) -> None:
    with lab.open(write_notebook(course / 'lessons', 'items', CELLS)) as opened:
        opened.run_all()
        page = opened.page
        desk = Desk(page)
        desk.until_js("root.querySelector('.worlds canvas').ariaLabel.includes('turtle2')")
        for scheme, width in LOOKS:
            page.set_viewport_size({'width': width, 'height': 900})
            page.evaluate(
                "theme => window.jupyterapp.commands.execute('apputils:change-theme', { theme })", f'JupyterLab {scheme.title()}'
            )
            opened.show('view')
            page.locator(f'.desk[data-theme={scheme}]').wait_for()
            plot(desk, times=1 + LOOKS.index((scheme, width)))
            change_a_parameter(desk, red=80 * LOOKS.index((scheme, width)))
            desk.open('tree')
            desk.until('.tree', ' Hz, ')
            desk.open('launch')
            desk.until('.panel', 'turtle_tf2_demo.launch.py:')
            for number, name in enumerate(CELLS):
                opened.show(name)
                wider, alt, is_complete = page.evaluate(OUTPUT_FITS, number)
                assert wider <= 1 and is_complete, (name, scheme, width)
                assert ('target_frame = turtle1' in alt) == (name == 'two') and ('4 nodes' in alt) == (name in ('graph', 'two'))
                page.screenshot(path=shots / f'items-{name}-{scheme}-{width}.png')
        assert desk.errors == []


def plot(desk: Desk, times: int) -> None:
    """Type an expression that the plot does not have yet."""
    desk.open('plot')
    field = desk.page.get_by_label('an expression to plot')
    field.fill(f'{times} * tf(world, turtle2).x + /turtle1/pose.x')
    field.press('Enter')
    assert desk.page.locator('.panel [role=alert]').text_content() == ''
    desk.until('.keys', f'{times} * tf(world, turtle2).x')


def change_a_parameter(desk: Desk, red: int) -> None:
    """Type another value, which the table then marks as different from its default."""
    desk.open('parameters')
    desk.until('.params', '≠ turtle')  # the defaults have arrived, so the table stays
    desk.page.get_by_label('/sim background_r as a number').click()
    desk.page.keyboard.press('Control+A')
    desk.page.keyboard.type(str(red))
    desk.page.keyboard.press('Enter')
    desk.until('.params', '≠ 69')
    desk.until_js(f"root.querySelector('.worlds canvas').getContext('2d').getImageData(5, 5, 1, 1).data[0] === {red}")

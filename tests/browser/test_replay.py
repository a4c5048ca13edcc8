"""The replay in a real browser: the output of a cell on disk, without a network."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.advice.rendering import Mark
from edulaunch.canvas.turtle_scene import turtle_scene
from edulaunch.canvas.worlds import read_worlds
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import RecordingSource
from edulaunch.desk.view.timeline import Timeline
from edulaunch.engine.recording import Recording
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser


@pytest.fixture(scope='module')
def recording() -> Recording:
    """A leader that is driven on a square, with a pen of its own, and one who follows."""
    with edulaunch.Session() as session:
        session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
        session.run(1.5)
        start = session.host.start
        from edulaunch.engine.processes.spec import ProcessSpec

        pen = (
            'ros2',
            'service',
            'call',
            '/turtle1/set_pen',
            'turtlesim/srv/SetPen',
            '{r: 250, g: 20, b: 30, width: 6, "off": 0}',
        )
        go = ('ros2', 'topic', 'pub', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 2.0}, angular: {z: 1.2}}')
        for words in (pen, go):
            start(ProcessSpec(argv=words, name='ros2'))
        session.run(5)
        return session.recording()


@pytest.fixture(scope='module')
def cell(tmp_path_factory: pytest.TempPathFactory, recording: Recording) -> Path:
    """A page with the output of a cell that shows a replay, as an exported notebook has it."""
    page = tmp_path_factory.mktemp('replay') / 'cell.html'
    page.write_text(f'<!DOCTYPE html><meta charset="utf-8"><body>{recording.replay().html()}</body>', encoding='utf-8')
    return page


@pytest.fixture
def desk(browser: Any, tmp_path: Path, recording: Recording) -> Iterator[Desk]:
    file = tmp_path / 'replay.html'
    recording.replay().save(file)
    context = browser.new_context(viewport={'width': 1200, 'height': 800}, offline=True)
    desk = Desk(context.new_page(), (file.as_uri(),))
    desk.page.goto(file.as_uri())
    desk.page.locator('.worlds canvas').first.wait_for()
    yield desk
    context.close()
    assert desk.errors == []


def test_stills_and_desk_show_the_same_scene(desk: Desk, recording: Recording) -> None:
    for colours in (False, True):
        for part in (0.0, 0.2, 0.31, 0.62, 1.0):
            check_the_scene(desk, recording, part, colours)


def check_the_scene(desk: Desk, recording: Recording, part: float, colours: bool) -> None:
    """What the page draws is what a still has."""
    desk.page.get_by_label('a colour for each trail').set_checked(colours)
    desk.seek(part)
    scene = turtle_scene(read_worlds(recording), desk.time(), colours=colours).windows[0]
    shown = {body.name: desk.pose(body.name) for body in scene.bodies}
    assert shown == {body.name: (pytest.approx(body.x, abs=0.04), pytest.approx(body.y, abs=0.04)) for body in scene.bodies}
    assert ('turtle2' in desk.label()) == ('turtle2' in shown)
    taken = [(body.x, body.y) for body in scene.bodies]
    for trail in scene.trails:
        far = [point for point in trail.points if all(math.dist(point, body) > 1.6 for body in taken)]
        if len(far) > 4:
            colour = desk.pixel(*far[len(far) // 2])
            assert all(abs(one - other) < 60 for one, other in zip(colour, trail.colour, strict=True)), (colour, trail.colour)
    assert desk.pixel(0.1, 0.1) == scene.background


def test_play_runs_and_pause_stands_still(desk: Desk) -> None:
    desk.press('play or pause')
    desk.until_js("parseFloat(root.querySelector('.clock').textContent) > 0.5")
    desk.press('play or pause')
    stopped = desk.time()
    desk.frame()
    desk.frame()
    assert desk.time() == stopped


def test_the_keyboard_plays_steps_and_jumps(desk: Desk) -> None:
    desk.page.locator('.worlds canvas').first.click()
    for key, clock in (('ArrowRight', 0.016), ('Shift+ArrowRight', 1.016), ('End', 6.5), ('ArrowLeft', 6.48), ('Home', 0.0)):
        desk.page.keyboard.press(key)
        desk.frame()
        assert desk.time() == pytest.approx(clock, abs=0.009)
    desk.page.keyboard.press(' ')
    desk.until('footer button', 'Pause')


def test_one_message_back_and_on(desk: Desk) -> None:
    desk.seek(0.5)
    desk.page.get_by_label('size of a step').select_option('message')
    before = desk.time()
    desk.press('one step forward')
    desk.frame()
    assert 0 < desk.time() - before <= 0.017
    desk.press('one step back')
    desk.frame()
    assert desk.time() <= before + 0.001


def test_tf_frames_are_shown_on_demand(desk: Desk) -> None:
    desk.seek(0.8)
    picture = 'canvas => canvas.toDataURL()'
    canvas = desk.page.locator('.worlds canvas').first
    before = canvas.evaluate(picture)
    desk.page.get_by_label('tf axes').check()
    desk.frame()
    assert canvas.evaluate(picture) != before
    desk.page.get_by_label('tf axes').uncheck()
    desk.frame()
    assert canvas.evaluate(picture) == before


def test_the_cell_plays_in_its_frame(browser: Any, cell: Path) -> None:
    page = browser.new_page()
    page.goto(cell.as_uri())
    page.frame_locator('iframe').locator('.worlds canvas').first.wait_for()
    page.close()


def test_where_frames_are_taken_out_the_filmstrip_is_seen(browser: Any, cell: Path) -> None:
    page = browser.new_page()
    text = cell.read_text(encoding='utf-8')
    page.set_content(text[: text.index('<iframe')] + '</div></body>')
    strip = page.locator('img')
    assert strip.is_visible() and strip.evaluate('image => image.naturalWidth') > 500
    assert str(strip.get_attribute('alt')).startswith('replay of 6.50 s: /sim with turtle1, turtle2')
    page.close()


ADVICE = [
    Mark(1.0, ('node', '/sim'), 'this window is a fine one', 'fine-window'),
    Mark(1.0, ('topic', '/turtle2/cmd_vel'), 'somebody follows here', 'following'),
    Mark(2.0, ('frame', 'turtle2'), 'this frame came late', 'late-frame'),
]


def test_what_the_rules_say_stands_on_what_it_is_about(browser: Any, tmp_path: Path, recording: Recording, shots: Path) -> None:
    timeline = Timeline(RecordingSource(recording))
    timeline.mark(ADVICE)
    file = tmp_path / 'advice.html'
    file.write_text(recorded_page(timeline.delta(), 'advice'), encoding='utf-8')
    page = browser.new_page(viewport={'width': 1200, 'height': 800})
    desk = Desk(page)
    page.goto(file.as_uri())
    desk.seek(1.0)
    desk.until('svg .mark', 'fine-window')
    page.get_by_role('button', name='/turtle2/cmd_vel').click()
    desk.until('.told', 'somebody follows here (following)')
    page.locator('.alerts summary').click()
    page.screenshot(path=shots / 'advice.png')
    page.locator('.alerts button').filter(has_text='late').click()
    desk.until('.pane .told', 'this frame came late')
    desk.until('table td', '⚠ turtle2')
    desk.seek(0.2)
    assert page.locator('table td').filter(has_text='⚠').count() == 0, 'before its time nothing is said'
    desk.seek(1.0)
    desk.open('tree')
    desk.until('.tree .box', '⚠ turtle2')
    assert desk.errors == []
    page.close()


TWO_ROBOTS = """
from pathlib import Path
from ament_index_python import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node
def generate_launch_description():
    share, actions = get_package_share_directory('turtlebot3_gazebo'), []
    for number, (name, model) in enumerate((('tb1', 'burger'), ('tb2', 'waffle'))):
        urdf = Path(share, 'urdf', f'turtlebot3_{model}.urdf').read_text()
        robot = {'robot_description': urdf, 'frame_prefix': f'{name}/'}
        twist = '{twist: {linear: {x: 0.2}, angular: {z: %g}}}' % (0.3 - 0.5 * number)
        actions += [
            Node(package='robot_state_publisher', executable='robot_state_publisher', namespace=name, parameters=[robot]),
            Node(package='turtlebot3_gazebo', executable='waffle_simulator', namespace=name, parameters=[{'y_pose': number * 0.8}]),
            ExecuteProcess(cmd=['ros2', 'topic', 'pub', f'/{name}/cmd_vel', 'geometry_msgs/msg/TwistStamped', twist]),
        ]
    return LaunchDescription(actions)
"""


def test_two_robots_share_a_map_and_look_as_they_describe_themselves(browser: Any, tmp_path: Path, shots: Path) -> None:
    (tmp_path / 'two.launch.py').write_text(TWO_ROBOTS)
    recording = edulaunch.run(tmp_path / 'two.launch.py', duration_s=8)
    recording.replay().save(tmp_path / 'two.html')
    page = browser.new_page(viewport={'width': 1200, 'height': 800})
    desk = Desk(page)
    page.goto((tmp_path / 'two.html').as_uri())
    page.locator('.worlds canvas').first.wait_for()
    desk.seek(1.0)
    page.screenshot(path=shots / 'robots.png')
    (window,) = turtle_scene(read_worlds(recording), desk.time()).windows
    left, right, low, high = window.limits
    shown = {body.name: desk.pose(body.name) for body in window.bodies}
    assert shown == {body.name: (pytest.approx(body.x, abs=0.02), pytest.approx(body.y, abs=0.02)) for body in window.bodies}
    assert page.locator('.worlds canvas').count() == 1
    for body in window.bodies:
        (_, corners), dark = next(part for part in body.outline if part.kind == 'body'), (31, 41, 51)
        back = min(x for x, _ in corners) * 0.6  # behind the nose, within the box
        x, y = body.x + back * math.cos(body.theta), body.y + back * math.sin(body.theta)
        colour = page.locator('.worlds canvas').first.evaluate(
            '(canvas, [x, y]) => [...canvas.getContext("2d").getImageData(x * canvas.width, y * canvas.height, 1, 1).data]',
            [(x - left) / (right - left), (high - y) / (high - low)],
        )
        assert colour[2] > colour[0] + 30 and colour[:3] != dark, (body.name, colour)
    assert desk.errors == []
    page.close()

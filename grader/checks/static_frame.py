"""The rubric of static_frame.launch.py: two frames that never move, one of them at the height of a launch argument.

Two runs have heights that the student cannot predict. The frames in tf decide, and any program may publish them.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from random import Random
from typing import TYPE_CHECKING

from edugrade import Evidence, Failure, Mismatch, Missing, Rubric, Scenario, check
from edugrade.library.arguments import require_default
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.frames import numbers, require_frame, tilt, transforms, yaw

if TYPE_CHECKING:
    from edulaunch.engine.recording.records import Frame

ARGUMENT = 'height'
TOLERANCE_M = 0.005
TOLERANCE_RAD = 0.02
PUBLISHER = "Node(package='tf2_ros', executable='static_transform_publisher', arguments=[...])"


def scenarios(random: Random) -> list[Scenario]:
    """Return runs with a low laser, a high laser, and the default. Nothing moves, so the runs are short."""
    low, high = random.randint(15, 45) / 100, random.randint(80, 150) / 100
    given = [Scenario('low', {ARGUMENT: f'{low:.2f}'}, 5.0), Scenario('high', {ARGUMENT: f'{high:.2f}'}, 5.0)]
    return [*given, Scenario('usual', {}, 5.0, defaults={ARGUMENT: None})]


@check(points=1)
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)
    refuse_gone(run)


@check(points=2, needs=[no_node_dies])
def laser_is_on_tf(run: Evidence) -> None:
    """The frame laser has the parent base_link"""
    require_frame(run, 'laser', 'base_link', f'start {PUBLISHER} with --frame-id base_link and --child-frame-id laser')


def _height(run: Evidence, name: str) -> float:
    text = run.arguments_of(name)[ARGUMENT]
    try:
        return float(text)
    except ValueError:
        raise Mismatch(
            f'the default value of {ARGUMENT}', 'a number', text, where=run.source.place, try_="write default_value='0.5'"
        ) from None


@check(points=3, needs=[laser_is_on_tf])
def laser_is_in_its_place(run: Evidence) -> None:
    """The laser is 0.2 m in front of base_link, and the launch argument height is its height"""
    for name in run:
        height = _height(run, name)
        _require_place(run, name, 'laser', (0.2, 0.0, height), ("'0.2'", '', f"LaunchConfiguration('{ARGUMENT}')"))
        for frame in (sent.frame for sent in transforms(run, name)['laser']):
            if not (abs(yaw(frame)) <= TOLERANCE_RAD and tilt(frame) <= TOLERANCE_RAD):
                raise Mismatch(
                    'the direction of the laser',
                    'that of base_link',
                    f'a yaw of {yaw(frame):.2f} rad and a tilt of {tilt(frame):.2f} rad',
                    where=run.source.place,
                    try_='remove the angles from the arguments of its Node',
                )


@check(points=1, needs=[laser_is_on_tf], explained_by=[laser_is_in_its_place])
def argument_is_declared(run: Evidence) -> None:
    """The launch argument height is declared and has a default"""
    require_default(run, ARGUMENT, None, _require_height)


def _require_height(run: Evidence) -> None:
    """Require the laser at the height of the argument in each run."""
    for name in run:
        height = _height(run, name)
        for sent in transforms(run, name).get('laser', ())[-1:]:
            seen = sent.frame.translation[2]
            if not abs(seen - height) <= TOLERANCE_M:
                advice = f"write '--z', LaunchConfiguration('{ARGUMENT}') in the arguments of its Node"
                raise Mismatch('the height of the laser', f'{height:g}', f'{seen:g}', where=run.source.place, try_=advice)


@check(points=2, needs=[no_node_dies])
def camera_is_on_tf(run: Evidence) -> None:
    """The frame camera has the parent laser"""
    require_frame(run, 'camera', 'laser', f'start {PUBLISHER} with --frame-id laser and --child-frame-id camera')


@check(points=2, needs=[camera_is_on_tf])
def camera_is_in_its_place(run: Evidence) -> None:
    """The camera is 0.1 m above the laser and turned to the left"""
    for name in run:
        _require_place(run, name, 'camera', (0.0, 0.0, 0.1), ('', '', "'0.1'"))
        for sent in transforms(run, name)['camera']:
            _require_turn(run, sent.frame)


@check(points=1, needs=[no_node_dies], explained_by=[laser_is_on_tf, camera_is_on_tf])
def frames_are_static(run: Evidence) -> None:
    """Both frames are static: they are published once and stay valid"""
    for name in run:
        sent = transforms(run, name)
        for child in ('laser', 'camera'):
            if child not in sent:
                raise Missing(
                    f'the frame {child}',
                    expected='published once, on /tf_static',
                    where=run.source.place,
                    try_=f'use {PUBLISHER}',
                )
        moving = [child for child in ('laser', 'camera') if not all(item.frame.is_static for item in sent[child])]
        if moving:
            raise Failure(
                f'the frame {" and the frame ".join(moving)} should be static',
                expected='published once, on /tf_static',
                seen='published on /tf',
                where=run.source.place,
                try_=f'use {PUBLISHER}',
            )


def _require_place(run: Evidence, name: str, child: str, wanted: tuple[float, float, float], codes: Sequence[str]) -> None:
    """Require the position of a frame. `codes` has the code of each coordinate for the advice, or '' for 0."""
    for frame in (sent.frame for sent in transforms(run, name)[child]):
        wrong = [axis for axis in range(3) if not abs(frame.translation[axis] - wanted[axis]) <= TOLERANCE_M]
        if not wrong:
            continue
        words = [f"write '--{'xyz'[axis]}', {codes[axis]}" if codes[axis] else f"remove '--{'xyz'[axis]}'" for axis in wrong]
        raise Mismatch(
            f'the position of {child} relative to {frame.parent}',
            f'x, y, z = {numbers(wanted)} m',
            f'x, y, z = {numbers(frame.translation)} m',
            where=run.source.place,
            try_=f'{", and ".join(words)} in the arguments of its static_transform_publisher',
            during=run.scenario(name).words,
        )


def _require_turn(run: Evidence, frame: Frame) -> None:
    if not (abs(yaw(frame) - pi / 2) <= TOLERANCE_RAD and tilt(frame) <= TOLERANCE_RAD):
        lean = f' and a tilt of {tilt(frame):.2f} rad' if tilt(frame) > TOLERANCE_RAD else ''
        raise Mismatch(
            'the direction of the camera',
            'a yaw of 1.57 rad, a quarter turn to the left',
            f'a yaw of {yaw(frame):.2f} rad{lean}',
            where=run.source.place,
            try_="write '--yaw', '1.5708' in the arguments of its Node: angles are in radians, and positive to the left",
        )


RUBRIC = Rubric(
    title='A laser and a camera on a mast',
    decoys=0.75,  # any program can publish a static frame; the other points depend on the launch argument
    scenarios=scenarios,
    checks=[
        no_node_dies,
        laser_is_on_tf,
        laser_is_in_its_place,
        argument_is_declared,
        camera_is_on_tf,
        camera_is_in_its_place,
        frames_are_static,
    ],
)

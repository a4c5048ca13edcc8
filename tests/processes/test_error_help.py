"""The line of help below a traceback."""
from __future__ import annotations

from typing import Any

import pytest


@pytest.mark.parametrize(('text', 'help'), [
    ('import gazebo_msgs.msg', "program-1 needs the module 'gazebo_msgs' (Gazebo), which is not here; the other programs go on without it"),
    ('import geometry_mgs.msg', "program-1 needs the module 'geometry_mgs', which is not here; did you mean 'geometry_msgs'?"),
    ('import course_interfaces.msg', "program-1 needs the module 'course_interfaces', which is not here: "
     'is the package with these interfaces in the workspace?'),
    ('import qqq_zzz', "program-1 needs the module 'qqq_zzz', which is not here. If it is no module of yours, try: pip install qqq_zzz"),
    ('from robot import arm', None),
    ('import robot.amr', 'did you mean robot.arm?'),
    ('from geometry_msgs.msg import Twist\nTwist().linaer', "did you mean 'linear'?"),
])
def test_help(world: Any, text: str, help: str | None) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/arm.py', '')
    lines = world.run(text).splitlines()
    assert (lines[-1] if lines else None) == (None if help is None else f'  help: {help}')


def test_the_program_is_named_as_the_launch_file_names_it(world: Any) -> None:
    world.start(world.write('p.py', 'import cv2_nothing_of_the_kind'), 'eye-3', package='vision', executable='eye')
    world.sim.run()
    assert "help: eye-3 (eye of vision) needs the module 'cv2_nothing_of_the_kind'" in world.log[-1][2]

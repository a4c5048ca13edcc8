"""The exercises whose rubric is YAML: near misses fail in the check that is about them. (That every solution gets all points says
`python -m edugrade.course_check`, a step of `.ci/run`.)
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from edugrade.grading import grade, plan_work
from edugrade.submission import Submission

SOLUTIONS = Path(__file__).resolve().parents[3] / 'solutions'
MISSES = [
    (
        'two_rooms.launch.py',
        "namespace='hall'),\n        Node(package='demo_nodes_py', executable='listener', namespace=room",
        "namespace='hall'),\n        Node(package='demo_nodes_py', executable='listener', namespace='kitchen'",
        'other',
    ),
    ('two_rooms.launch.py', "('chatter', '/hall/chatter')", "('/chatter', '/hall/chatter')", 'heard'),
    (
        'silent_listener.launch.py',
        "name='radio', remappings=[('chatter',",
        "name='radio', remappings=[('/chattr',",
        'first_hears',
    ),
    ('water.launch.py', 'LaunchConfiguration(colour)', "LaunchConfiguration('red')", 'green_water'),
    ('water.launch.py', "default_value='86'", "default_value='87'", 'green'),
    ('on_request.launch.py', 'condition=IfCondition(drive)', "condition=IfCondition('true')", 'quiet'),
    ('on_request.launch.py', "EqualsSubstitution(worlds, '2')", "EqualsSubstitution(worlds, '1')", 'quiet'),
    ('fence.launch.py', "SetParameter('background_b', blue)", "SetParameter('background_b', 40)", 'fenced_water'),
    ('in_order.launch.py', 'period=delay', 'period=2.0', 'after_driver'),
    ('in_order.launch.py', 'RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[driver]))', 'driver', 'after_sim'),
    ('rooms.launch.xml', '$(var room)', 'kitchen', 'lives'),
    ('tower.launch.py', "'--yaw', '1.5708'", "'--yaw', '-1.5708'", 'lamp_place'),
    ('mast.launch.py', 'xyz="0 0 0.3"', 'xyz="0 0.3 0"', 'camera_place'),
    ('mast.launch.py', "position: [', angle", "position: [', '0.5'", 'angle'),
    (
        'visitors.launch.py',
        "spawn('{x: ', LaunchConfiguration('x'), ', y: 2.0, name: carl}')",
        "spawn('{x: 3.0, y: 2.0, name: carl}')",
        'visitor_two',
    ),
    ('lost_carrot.launch.py', "{'target_frame': 'carrot1'}", "{'target_frame': 'turtle1'}", 'asked'),
    (
        'careful.launch.py',
        'target_action=echo, on_exit=[driver]',
        'target_action=echo, on_exit=[TimerAction(period=2.0, actions=[driver])]',
        'after_word',
    ),
    ('careful.launch.py', 'period=end', 'period=5.0', 'ends'),
    ('careful.launch.py', "actions=[Shutdown(reason='that is enough')]", 'actions=[]', 'ends'),
    ('news_desk/setup.py', "glob('config/*')", "glob('confg/*')", 'word'),
    ('news_desk/setup.py', 'news_desk.listen:main', 'news_desk.hello:main', 'hears'),
    ('two_turtles/two_turtles/broadcaster.py', 'child_frame_id = self.turtle', "child_frame_id = 'turtle2'", 'first'),
    ('two_turtles/two_turtles/broadcaster.py', 'sin(pose.theta / 2)', 'sin(pose.theta)', 'follows'),
    ('where_now/where_now/where.py', "self.say('newest', Time())", "self.say('newest', now)", 'newest'),
    ('where_now/where_now/where.py', 'now - self.ago', 'now - Duration(seconds=0.5)', 'longer'),
    ('two_seas/launch/two_seas.launch.py', 'blue=blue', "blue='200'", 'south_blue'),
    ('two_seas/config/sea.yaml', '/**/sim', '/*/sin', 'south_red'),
    ('black_box.launch.py', 'on_start=[drive]', 'on_start=[]', 'driver'),
    ('black_box.launch.py', "['/', robot, '/turtle1/pose']", "'/red/turtle1/pose'", 'poses'),
    ('two_pools.launch.py', "'input/pose'", "'input'", 'listens'),
    ('two_pools.launch.py', "'/first/turtle1/cmd_vel'", "'/second/turtle1/cmd_vel'", 'circle'),
]


def failed(path: Path) -> list[str]:
    (report,) = grade([plan_work(Submission(str(path)))])
    return [result.name for result in report.results if result.status == 'failed']


@pytest.mark.processes
@pytest.mark.parametrize(('name', 'old', 'new', 'check'), MISSES)
def test_a_near_miss_fails_where_it_misses(tmp_path: Path, name: str, old: str, new: str, check: str) -> None:
    text, top = (SOLUTIONS / name).read_text(), name.split('/')[0]
    assert text.count(old) == 1, name
    if top != name:
        shutil.copytree(SOLUTIONS / top, tmp_path / top)
    (tmp_path / name).write_text(text.replace(old, new))
    assert check in failed(tmp_path / top)

"""The page of a plan."""

from __future__ import annotations

from edulaunch.advice.explaining.systems import System, SystemFrame, SystemNode
from edulaunch.desk.view.planned import planned_delta, planned_page

PLAN = System(
    'my.launch.py',
    [SystemNode('/a', 'p q', 'source', [('publisher', '/t', 'x/msg/Y')], ['client (name: n)'], {'k': 1.0})],
    [SystemFrame('world', 'arm', True, ['/a'])],
)


def test_a_plan_is_a_timeline_of_no_length() -> None:
    delta = planned_delta(PLAN)
    assert delta['now'] == 0 and delta['nodes'] == [[0, '/a', 'p q', 0, 0, None]]
    assert delta['endpoints'] == [[0, 'publisher', '/t', 'x/msg/Y', 0, 0, []]]
    assert delta['parameters'] == [[0, '/a', 'k', 1.0, 'the launch file', True]]
    assert delta['planned'] == {
        'frames': [['world', 'arm', True, ['/a']]],
        'unknown': {'/a': ['client (name: n)']},
        'source': {'/a': 'source'},
    }


def test_the_page_has_the_name_of_the_launch_file() -> None:
    assert '<title>my.launch.py</title>' in planned_page(PLAN)

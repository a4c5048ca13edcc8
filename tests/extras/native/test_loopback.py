from __future__ import annotations

import pytest

from edulaunch.extras.native.loopback import confined

ALONE = {'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}
NAME = 'FASTRTPS_DEFAULT_PROFILES_FILE'


@pytest.mark.parametrize(
    ('env', 'expected'),
    [
        (ALONE, True),
        ({'ROS_LOCALHOST_ONLY': '1'}, True),
        ({**ALONE, 'ROS_STATIC_PEERS': ' ; '}, True),
        ({**ALONE, 'ROS_STATIC_PEERS': '10.0.0.2'}, False),
        ({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}, False),
        ({**ALONE, 'FASTDDS_DEFAULT_PROFILES_FILE': '/my.xml'}, False),
    ],
)
def test_programs_stay_on_the_loopback_where_that_is_meant(env: dict[str, str], expected: bool) -> None:
    assert (NAME in confined(env)) is expected


def test_a_program_that_asks_for_more_gets_more() -> None:
    inherited = confined(ALONE)
    assert NAME not in confined({**inherited, 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'})
    assert confined({**ALONE, NAME: '/my.xml'})[NAME] == '/my.xml'

import pytest

from edulaunch.interfaces.underlay import underlay_registry

MORE = [
    'actionlib_msgs/msg/GoalID',
    'actionlib_msgs/msg/GoalStatus',
    'actionlib_msgs/msg/GoalStatusArray',
    'nav_msgs/msg/Goals',
    'rmw_dds_common/msg/Gid',
    'rmw_dds_common/msg/NodeEntitiesInfo',
    'rmw_dds_common/msg/ParticipantEntitiesInfo',
    'stereo_msgs/msg/DisparityImage',
]
"""What Jazzy's common_interfaces has beyond the list, and what its nodes tell each other of themselves; test_msgs is there for tests that use it."""


def test_the_underlay_is_one_registry():
    assert underlay_registry() is underlay_registry()


def test_every_interface_of_the_reference_list_is_there(registry, shared):
    """Field by field, in order: names and constants as the Jazzy lines of the list have them."""
    lines = [line.strip() for line in (shared / 'reference' / 'interfaces.txt').read_text().splitlines() if line[:1].isalpha()]
    students_own = ('tutorial_interfaces', 'more_interfaces')
    wanted = {line.split(': ')[0]: line.split(': ', 1)[1] for line in lines if not line.startswith(students_own)}
    more = [name for name in registry.types() if name not in wanted]
    assert more == sorted(MORE + [name for name in more if name.startswith('test_msgs/')])
    assert set(wanted) <= set(registry.types())
    for name, text in wanted.items():
        parts = [
            [
                item.split(':=')[0].split('=')[0].split()[1] if '<=' not in item else item.split()[1]
                for item in part.split('; ')
                if item.strip() not in ('', '(empty)')
            ]
            for part in text.split('---')
        ]
        ours = [
            [line.split('#')[0].split()[1].split('=')[0] for line in part.splitlines() if line.strip()]
            for part in registry.text(name).split('---')
        ]
        assert ours == parts, name


@pytest.fixture
def shared():
    from pathlib import Path

    folder = Path(__file__).resolve().parents[3] / 'shared'
    if not folder.is_dir():
        pytest.skip('the reference folder ../shared is not there')
    return folder

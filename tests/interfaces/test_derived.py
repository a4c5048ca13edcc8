from edulaunch.interfaces.derived import parts_of
from edulaunch.interfaces.parser import parse


def test_an_action_brings_all_its_parts():
    parts = parts_of(parse('---\n---', 'p/action/A'))
    assert sorted(name.removeprefix('p/action/A') for name in parts) == [
        '',
        '_Feedback',
        '_FeedbackMessage',
        '_GetResult',
        '_GetResult_Event',
        '_GetResult_Request',
        '_GetResult_Response',
        '_Goal',
        '_Result',
        '_SendGoal',
        '_SendGoal_Event',
        '_SendGoal_Request',
        '_SendGoal_Response',
    ]

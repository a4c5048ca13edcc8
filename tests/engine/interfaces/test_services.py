import pytest

from edulaunch.engine.interfaces.parser import parse
from edulaunch.engine.interfaces.services import parts_of


def test_a_service_class_holds_its_messages(get):
    spawn = get('turtlesim/srv/Spawn')
    assert [part.__name__ for part in (spawn.Request, spawn.Response, spawn.Event)] == [
        'Spawn_Request',
        'Spawn_Response',
        'Spawn_Event',
    ]
    assert spawn.Event.get_fields_and_field_types() == {
        'info': 'service_msgs/ServiceEventInfo',
        'request': 'sequence<turtlesim/Spawn_Request, 1>',
        'response': 'sequence<turtlesim/Spawn_Response, 1>',
    }


def test_an_action_class_holds_its_messages_and_the_services_behind_it(get):
    rotate = get('turtlesim/action/RotateAbsolute')
    impl = rotate.Impl
    assert (rotate.Goal(theta=1.0).theta, rotate.Result().delta, rotate.Feedback().remaining) == (1.0, 0.0, 0.0)
    assert list(impl.SendGoalService.Request.get_fields_and_field_types()) == ['goal_id', 'goal']
    assert list(impl.SendGoalService.Response.get_fields_and_field_types()) == ['accepted', 'stamp']
    assert list(impl.GetResultService.Response.get_fields_and_field_types()) == ['status', 'result']
    assert impl.FeedbackMessage(feedback=rotate.Feedback(remaining=2.0)).feedback.remaining == 2.0
    assert impl.CancelGoalService is get('action_msgs/srv/CancelGoal')
    assert impl.GoalStatusMessage is get('action_msgs/msg/GoalStatusArray')


@pytest.mark.parametrize(
    ('type_name', 'text'),
    [
        ('turtlesim/srv/Spawn', 'Service classes can not be instantiated'),
        ('turtlesim/action/RotateAbsolute', 'Action classes can not be instantiated'),
    ],
)
def test_services_and_actions_are_never_instantiated(get, type_name, text):
    with pytest.raises(NotImplementedError) as caught:
        get(type_name)()
    assert str(caught.value) == text


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

import pytest

from edulaunch.engine.facts import facts_of
from edulaunch.engine.interfaces.message import Lazy, Notices, rules_of, spec_of


def test_repr_names_every_field_and_nested_message(get):
    msg = get('geometry_msgs/msg/Twist')()
    msg.linear.x = 2.0
    assert repr(msg) == (
        'geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, z=0.0), '
        'angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=0.0))'
    )


def test_repr_shows_number_sequences_as_lists_and_fixed_arrays_as_numpy_does(get):
    layout = 'layout=std_msgs.msg.MultiArrayLayout(dim=[], data_offset=0)'
    assert repr(get('std_msgs/msg/Int32MultiArray')(data=[1])) == f'std_msgs.msg.Int32MultiArray({layout}, data=[1])'
    assert repr(get('shape_msgs/msg/Plane')()) == 'shape_msgs.msg.Plane(coef=array([0., 0., 0., 0.]))'


def test_a_request_shows_its_long_name(get):
    assert repr(get('turtlesim/srv/Spawn').Request(x=2.0)) == "turtlesim.srv.Spawn_Request(x=2.0, y=0.0, theta=0.0, name='')"


def test_unknown_arguments_are_ignored_as_in_jazzy_and_noted(get, monkeypatch):
    noted = []
    monkeypatch.setattr(Notices, 'ignored', lambda *facts: noted.append(facts))
    twist = get('geometry_msgs/msg/Twist')
    assert twist(linaer=1, angluar=2, angular=get('geometry_msgs/msg/Vector3')(z=2.0)).angular.z == 2.0
    assert noted == [(twist, 'angluar', 'angular')]


def test_a_message_and_its_metaclass_have_the_names_of_rclpy(get):
    string, trigger = get('std_msgs/msg/String'), get('std_srvs/srv/Trigger')
    assert (str(type(string)), string.__doc__) == ("<class 'std_msgs.msg._string.Metaclass_String'>", "Message class 'String'.")
    assert str(type(trigger)) == "<class 'std_srvs.srv._trigger.Metaclass_Trigger'>"
    assert str(type(trigger.Request)) == "<class 'std_srvs.srv._trigger.Metaclass_Trigger_Request'>"
    assert (string.__import_type_support__(), string._TYPE_SUPPORT, trigger._TYPE_SUPPORT) == (None, None, None)


def test_check_fields_is_taken_but_checks_stay_on(get):
    with pytest.raises(AssertionError, match="The 'x' field must be of type 'float'"):
        get('geometry_msgs/msg/Point')(check_fields=False, x=1)


def test_wire_type_describes_each_entry(get):
    assert get('std_msgs/msg/Header').wire_type() == (('stamp.sec', 'int32'), ('stamp.nanosec', 'uint32'), ('frame_id', 'string'))


def test_a_lazy_attribute_is_computed_once():
    calls = []

    class Owner:
        value = Lazy(lambda: calls.append('computed') or 5)

    assert (calls, Owner.value, Owner.value, calls) == (['computed'], 5, 5, ['computed'])


def test_check_fields_refuses_an_unknown_name(get):
    with pytest.raises(AssertionError, match='Invalid arguments passed to constructor: w'):
        get('geometry_msgs/msg/Point')(check_fields=True, x=1.0, w=1.0)


def test_an_unknown_name_is_refused_before_any_value_is_looked_at(get):
    with pytest.raises(AssertionError, match='Invalid arguments'):
        get('geometry_msgs/msg/Point')(check_fields=True, x='wrong too', w=1.0)


def test_an_unknown_name_has_the_facts_for_an_explanation(get):
    with pytest.raises(AssertionError) as caught:
        get('geometry_msgs/msg/Point')(check_fields=True, zz=1.0, xx=1.0)
    assert str(caught.value) == 'Invalid arguments passed to constructor: xx, zz'
    assert facts_of(caught.value) == {
        'about': 'messages.field',
        'type': 'Point',
        'field': 'xx',
        'near': 'x',
        'fields': ['x', 'y', 'z'],
    }


def test_an_unknown_argument_is_no_error_where_nobody_listens(get, monkeypatch):
    monkeypatch.setattr(Notices, 'ignored', None)
    assert get('geometry_msgs/msg/Point')(z=2.0, w=1.0).z == 2.0


def test_check_fields_alone_is_not_noted_as_an_unknown_argument(get, monkeypatch):
    noted = []
    monkeypatch.setattr(Notices, 'ignored', lambda *facts: noted.append(facts))
    assert get('geometry_msgs/msg/Point')(check_fields=True, x=1.0).x == 1.0
    assert noted == []


def test_the_definition_is_that_of_the_class_and_of_its_messages(get):
    pose = get('geometry_msgs/msg/Pose')
    assert spec_of(pose) is spec_of(pose())
    assert (spec_of(pose).type, [field.name for field in spec_of(pose).fields]) == (
        'geometry_msgs/msg/Pose',
        ['position', 'orientation'],
    )
    assert rules_of(pose)['position'].message is get('geometry_msgs/msg/Point')

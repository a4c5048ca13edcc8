import pytest

from edulaunch.interfaces.field_facts import field_facts


def facts_after(registry, action):
    with pytest.raises(AttributeError) as caught:
        action()
    found = field_facts(caught.value, registry)
    return (found['type'], found['near'], found['fields']) if found else None


def test_of_a_misspelt_field_the_nearest_is_known(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert facts_after(registry, lambda: setattr(msg, 'linaer', 1.0)) == ('Twist', 'linear', ['linear', 'angular'])
    assert facts_after(registry, lambda: msg.angluar) == ('Twist', 'angular', ['linear', 'angular'])


def test_of_a_far_name_the_fields_are_known(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert facts_after(registry, lambda: setattr(msg, 'q', 1.0)) == ('Twist', None, ['linear', 'angular'])
    empty = get('std_msgs/msg/Empty')()
    assert facts_after(registry, lambda: setattr(empty, 'data', 1.0)) == ('Empty', None, [])


def test_of_other_errors_nothing_is(registry):
    assert facts_after(registry, lambda: [].push) is None
    assert field_facts(ValueError("'Twist' object has no attribute 'x'"), registry) == {}

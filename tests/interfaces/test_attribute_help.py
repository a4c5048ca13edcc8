import pytest

from edulaunch.interfaces.attribute_help import attribute_help


def help_after(registry, action):
    with pytest.raises(AttributeError) as caught:
        action()
    return attribute_help(caught.value, registry)


def test_a_misspelt_assignment_names_the_nearest_field(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert help_after(registry, lambda: setattr(msg, 'linaer', 1.0)) == "did you mean 'linear'?"
    assert help_after(registry, lambda: msg.angluar) == "did you mean 'angular'?"


def test_a_far_name_lists_the_fields(registry, get):
    msg = get('geometry_msgs/msg/Twist')()
    assert help_after(registry, lambda: setattr(msg, 'q', 1.0)) == 'the fields of Twist are: linear, angular'
    empty = get('std_msgs/msg/Empty')()
    assert help_after(registry, lambda: setattr(empty, 'data', 1.0)) == 'Empty has no fields'


def test_other_errors_get_no_help(registry):
    assert help_after(registry, lambda: [].push) is None
    assert attribute_help(ValueError("'Twist' object has no attribute 'x'"), registry) is None

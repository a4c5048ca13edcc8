import pytest

from edulaunch.interfaces.modules import homes_of
from edulaunch.interfaces.unknown import type_help


@pytest.mark.parametrize(
    ('name', 'help'),
    [
        ('std_msgs/msg/Twist', 'Twist is in geometry_msgs.msg'),
        ('turtlesim/msg/Spawn', "did you mean 'turtlesim/srv/Spawn'?"),
        ('geometry_msg/msg/Foo', "did you mean 'geometry_msgs'?"),
        ('zzz/msg/Foo', 'no package with interfaces has this name: is its workspace built and sourced?'),
    ],
)
def test_help_names_the_place_or_the_nearest_name(registry, name, help):
    assert type_help(registry, name) == help


def test_homes_are_import_paths(registry):
    assert homes_of(registry, 'SetBool') == ['example_interfaces.srv', 'std_srvs.srv']

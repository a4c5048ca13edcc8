import inspect
import sys

import pytest

from edulaunch.facts import facts_of
from edulaunch.interfaces.modules import InterfaceModule, PartModule


@pytest.fixture
def module(registry, monkeypatch):
    module = InterfaceModule('std_msgs.msg', registry)
    monkeypatch.setitem(sys.modules, 'std_msgs.msg', module)
    return module


@pytest.mark.parametrize(
    ('name', 'homes', 'near'),
    [
        ('Twist', ['geometry_msgs.msg'], None),
        ('Strnig', [], 'String'),
        ('SetBool', ['example_interfaces.srv', 'std_srvs.srv'], 'Bool'),
    ],
)
def test_a_wrong_name_in_from_import_is_an_import_error_with_facts(module, name, homes, near):
    with pytest.raises(ImportError) as caught:
        exec(f'from std_msgs.msg import {name}')
    assert str(caught.value) == f"cannot import name '{name}' from 'std_msgs.msg' (unknown location)"
    assert (facts_of(caught.value)['homes'], facts_of(caught.value)['near']) == (homes, near)


def test_a_wrong_attribute_is_an_attribute_error_with_facts(module):
    with pytest.raises(AttributeError) as caught:
        module.Strnig  # noqa: B018
    assert str(caught.value) == "module 'std_msgs.msg' has no attribute 'Strnig'"
    assert facts_of(caught.value)['near'] == 'String'
    assert not hasattr(module, 'Strnig')


def test_a_module_lists_its_classes_without_making_them(module):
    assert {'Bool', 'String'} <= set(dir(module)) and 'String' not in vars(module)
    assert module.__all__ == sorted(module.__all__)
    assert inspect.unwrap(module) is module  # asks for names with underscores, which must be absent


def test_star_import_brings_all_classes(module):
    names = {}
    exec('from std_msgs.msg import *', names)
    assert set(module.__all__) <= set(names)


def test_a_part_module_has_the_classes_of_one_interface(registry):
    module = PartModule('turtlesim.srv._spawn', registry, 'turtlesim/srv/Spawn')
    assert (module.Spawn.TYPE, module.Spawn_Response.TYPE) == ('turtlesim/srv/Spawn', 'turtlesim/srv/Spawn_Response')
    assert not hasattr(module, 'Kill') and not hasattr(module, 'Spawn_Reply')

import importlib
import inspect
import subprocess
import sys

import pytest

from edulaunch.engine.facts import facts_of
from edulaunch.engine.interfaces import current_registry, install
from edulaunch.engine.interfaces.importer import InterfaceFinder, InterfaceModule, PartModule, uninstall
from edulaunch.engine.interfaces.registry import Registry


@pytest.fixture
def finder(registry):
    before = current_registry()
    install(registry)
    yield
    install(before)


def test_classes_are_imported_by_name(finder, get):
    from geometry_msgs.msg import Pose, Twist

    assert (Twist, Pose) == (get('geometry_msgs/msg/Twist'), get('geometry_msgs/msg/Pose'))


def test_a_module_is_found_by_every_form_of_import(finder, get):
    import geometry_msgs.msg
    import turtlesim.srv as srv
    from turtlesim import action

    assert geometry_msgs.msg.Twist is get('geometry_msgs/msg/Twist')
    assert (srv.Spawn.TYPE, action.RotateAbsolute.TYPE) == ('turtlesim/srv/Spawn', 'turtlesim/action/RotateAbsolute')


def test_private_modules_of_ros_can_be_imported(finder, get):
    from geometry_msgs.msg._transform_stamped import TransformStamped
    from turtlesim.srv import Spawn_Request as from_package
    from turtlesim.srv._spawn import Spawn_Request

    assert from_package is Spawn_Request
    assert (TransformStamped, Spawn_Request) == (get('geometry_msgs/msg/TransformStamped'), get('turtlesim/srv/Spawn').Request)


@pytest.mark.parametrize('name', ['geometry_msgs.mgs', 'geometry_msgs.srv', 'geometry_msgs.msg._twits', 'no_such_msgs'])
def test_what_is_not_there_is_pythons_own_error(finder, name):
    with pytest.raises(ModuleNotFoundError, match=f"^No module named '{name}'$"):
        importlib.import_module(name)


def test_a_real_package_keeps_its_place_and_a_bare_folder_does_not(tmp_path, registry, monkeypatch):
    for package in ('real_pkg', 'bare_pkg'):
        (tmp_path / package / 'msg').mkdir(parents=True)
        (tmp_path / package / 'msg' / 'Num.msg').write_text('int64 num')
    (tmp_path / 'real_pkg' / '__init__.py').write_text('')
    monkeypatch.syspath_prepend(tmp_path)
    finder = InterfaceFinder(Registry([tmp_path], base=registry))
    specs = [finder.find_spec(name) for name in ('real_pkg', 'real_pkg.msg', 'bare_pkg', 'bare_pkg.msg', 'os')]
    assert [spec and spec.name for spec in specs] == [None, 'real_pkg.msg', 'bare_pkg', 'bare_pkg.msg', None]


def test_uninstall_takes_the_modules_away(finder):
    import std_srvs.srv

    assert repr(std_srvs.srv) == "<module 'std_srvs.srv' (edulaunch interfaces)>"
    uninstall()
    assert 'std_srvs.srv' not in sys.modules
    assert not any(isinstance(finder, InterfaceFinder) for finder in sys.meta_path)


def test_classes_are_asked_for_by_type_name(tmp_path, registry, finder):
    (tmp_path / 'p' / 'msg').mkdir(parents=True)
    (tmp_path / 'p' / 'msg' / 'Num.msg').write_text('int64 num')
    install(Registry([tmp_path], base=registry))
    assert (current_registry().get('p/msg/Num')(num=3).num, current_registry().get('std_srvs/srv/Empty').TYPE) == (
        3,
        'std_srvs/srv/Empty',
    )


@pytest.mark.processes
def test_using_messages_loads_neither_numpy_nor_asyncio():
    code = """if True:
        import sys
        from edulaunch.engine.interfaces import install
        install()
        from nav_msgs.msg import Odometry
        Odometry.from_wire(Odometry.to_wire(Odometry(child_frame_id='base')))
        late = ('numpy', 'asyncio', 'dataclasses', 'difflib', 'json')
        print([name for name in late if name in sys.modules])
    """
    assert subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True).stdout == '[]\n'


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

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.interfaces import registry as registry_module
from edulaunch.engine.interfaces.registry import Registry, answer_with, underlay_registry
from edulaunch.errors import InterfaceError


@pytest.fixture
def workspace(tmp_path, registry):
    """workspace({'p/msg/A.msg': 'text'}) -> a registry over the underlay."""

    def write(files):
        for name, text in files.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return Registry([tmp_path], base=registry)

    return write


def message(call, *args):
    with pytest.raises(InterfaceError) as caught:
        call(*args)
    return str(caught.value)


def test_a_class_is_made_once(registry):
    assert registry.get('geometry_msgs/msg/Twist') is registry.get('geometry_msgs/msg/Twist')


def test_a_workspace_shares_the_classes_of_the_underlay(workspace, registry):
    ws = workspace({'p/msg/Sphere.msg': 'geometry_msgs/Point center\nfloat64 radius'})
    point = registry.get('geometry_msgs/msg/Point')
    assert ws.get('geometry_msgs/msg/Point') is point is type(ws.get('p/msg/Sphere')().center)


def test_a_workspace_package_stands_before_one_of_the_underlay(workspace):
    ws = workspace({'turtlesim/msg/Shell.msg': 'int8 a'})
    assert (ws.names('turtlesim', 'msg'), ws.has('turtlesim', 'srv')) == (['Shell'], False)


def test_packages_kinds_and_names_are_listed_in_order(registry):
    assert registry.names('turtlesim', 'srv') == ['Kill', 'SetPen', 'Spawn', 'TeleportAbsolute', 'TeleportRelative']
    assert registry.types('action') == [
        'action_tutorials_interfaces/action/Fibonacci',
        'example_interfaces/action/Fibonacci',
        'test_msgs/action/Fibonacci',
        'test_msgs/action/NestedMessage',
        'tf2_msgs/action/LookupTransform',
        'turtlesim/action/RotateAbsolute',
    ]
    assert 'std_msgs' in registry.packages()


def test_the_text_of_an_interface_keeps_its_comments(registry):
    assert registry.text('turtlesim/srv/Spawn').splitlines()[3].startswith('string name # Optional.')
    assert registry.text('std_srvs/srv/Empty') == '---\n'


def test_new_files_are_seen_after_a_refresh(workspace):
    ws = workspace({'p/msg/A.msg': 'int8 a'})
    ws.names('p', 'msg')
    workspace({'p/msg/B.msg': 'int8 b'})
    ws.refresh()
    assert ws.names('p', 'msg') == ['A', 'B']


def test_an_unknown_type_is_named_with_the_nearest(registry):
    assert message(registry.get, 'geometry_msgs/msg/Twits') == (
        "unknown interface 'geometry_msgs/msg/Twits'\n  help: did you mean 'geometry_msgs/msg/Twist'?"
    )


def test_a_field_of_an_unknown_type_is_reported_at_its_line(workspace, tmp_path):
    ws = workspace({'p/msg/A.msg': 'int8 a\ngeometry_msgs/Vector b'})
    assert message(ws.get, 'p/msg/A') == (
        f"{tmp_path}/p/msg/A.msg:2: unknown interface 'geometry_msgs/msg/Vector', the type of field 'b'\n"
        "  help: did you mean 'geometry_msgs/msg/Vector3'?"
    )


def test_a_message_that_contains_itself_is_refused(workspace):
    ws = workspace({'p/msg/A.msg': 'B[] b', 'p/msg/B.msg': 'A a'})
    assert message(ws.get, 'p/msg/A') == (
        'p/msg/A contains itself: p/msg/A -> p/msg/B -> p/msg/A\n  help: a message must have a finite size'
    )


@pytest.mark.parametrize('name', ['Twist', 'geometry_msgs/Twist', '', 'a/b/c/d', 'turtlesim/srv/Spawn_Reply'])
def test_what_is_no_full_type_name_is_an_interface_error(registry, name):
    assert message(registry.get, name).startswith(f"unknown interface '{name}'")


def test_a_thread_that_wants_a_class_in_the_making_waits_for_it(workspace, monkeypatch):
    ws = workspace({'p/msg/A.msg': 'int8 a'})
    make, found, threads = ws._make, [], []

    def slowly(spec):
        if not threads:
            threads.append(threading.Thread(target=lambda: found.append(ws.get('p/msg/A'))))
            threads[0].start()
            threads[0].join(0.05)
        return make(spec)

    monkeypatch.setattr(ws, '_make', slowly)
    cls = ws.get('p/msg/A')
    threads[0].join(5)
    assert found == [cls]


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

    folder = Path(__file__).resolve().parents[4] / 'shared'
    if not folder.is_dir():
        pytest.skip('the reference folder ../shared is not there')
    return folder


@pytest.fixture
def source() -> Iterator[Registry]:
    before = list(registry_module._sources)
    registry = Registry([])
    answer_with(lambda: registry)
    yield registry
    registry_module._sources[:] = before


def test_the_running_programs_interfaces_go_first(source: Registry) -> None:
    assert current_registry() is source
    answer_with(lambda: None)
    assert current_registry() is not source

"""Installed packages may add to the command line of each node."""

from __future__ import annotations

import logging
import sys
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext
from launch_ros.actions.node import Node, NodeActionExtension, get_extensions, instantiate_extension
from launch_ros.utilities.plugin_support import PluginException, satisfies_version

MODULE = """
from launch_ros.actions.node import NodeActionExtension


class Marking(NodeActionExtension):
    def prepare_for_execute(self, context, ros_specific_arguments, node_action):
        return ['--mark', node_action.node_name], {**ros_specific_arguments, 'mark': self.NAME}
"""


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'marking_extension.py').write_text(MODULE)
    folder = tmp_path / 'marking-1.0.dist-info'
    folder.mkdir()
    (folder / 'METADATA').write_text('Metadata-Version: 2.1\nName: marking\nVersion: 1.0\n')
    (folder / 'entry_points.txt').write_text(
        '[launch_ros.node_action]\nmark = marking_extension:Marking\nbroken = marking_extension:Missing\n'
    )
    monkeypatch.syspath_prepend(str(tmp_path))


def test_an_extension_adds_words_and_changes_the_local_variable(installed: None, monkeypatch: pytest.MonkeyPatch) -> None:
    from edulaunch.engine.processes.current import current_process

    monkeypatch.delitem(current_process().state, 'launch_ros.node_extensions', raising=False)
    context: Any = LaunchContext()
    node = Node(package='demo_nodes_py', executable='talker', name='me', namespace='/ns')
    node._perform_substitutions(context)
    arguments = node._Node__prepared_by_extensions(context)  # type: ignore[attr-defined]
    assert arguments == {'name': '__node:=me', 'ns': '__ns:=/ns', 'mark': 'mark'}
    assert [words[0].text for words in node.cmd[-2:]] == ['--mark', '/ns/me']
    monkeypatch.delitem(current_process().state, 'launch_ros.node_extensions')


def test_an_extension_without_a_method_of_its_own_adds_nothing() -> None:
    words = {'name': '__node:=me'}
    node = Node(package='demo_nodes_py', executable='talker')
    assert NodeActionExtension().prepare_for_execute(LaunchContext(), words, node) == ([], words)


def test_one_that_cannot_be_loaded_gives_a_warning(installed: None, caplog: pytest.LogCaptureFixture) -> None:
    found = get_extensions(logging.getLogger('extensions'))
    assert list(found) == ['mark'] and isinstance(found['mark'], NodeActionExtension)
    assert "Failed to load entry point 'broken'" in caplog.text


def test_without_any_importlib_metadata_is_not_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, 'launch.frontend.extensions', None)
    assert get_extensions(logging.getLogger('extensions')) == {}


def test_an_instance_is_kept_unless_it_is_to_be_unique() -> None:
    kept: dict[str, NodeActionExtension] = {}
    logger = logging.getLogger('extensions')
    one = instantiate_extension('group', 'it', NodeActionExtension, kept, logger)
    assert instantiate_extension('group', 'it', NodeActionExtension, kept, logger) is one
    assert instantiate_extension('group', 'it', NodeActionExtension, kept, logger, unique_instance=True) is not one
    assert instantiate_extension('group', 'bad', lambda: 1 / 0, kept, logger) is None


@pytest.mark.parametrize(
    ('version', 'wanted', 'problem'),
    [
        ('0.1', '^0.1', None),
        ('0.1.5', '^0.1', None),
        ('1.4', '^1.2', None),
        ('0.1', '^0.2', 'too old'),
        ('0.2', '^0.1', 'newer'),
        ('2.0', '^1.2', 'newer'),
        ('1.0', '^1.2', 'too old'),
    ],
)
def test_an_extension_says_which_extension_point_it_is_written_for(version: str, wanted: str, problem: str | None) -> None:
    if problem is None:
        satisfies_version(version, wanted)
    else:
        with pytest.raises(PluginException, match=problem):
            satisfies_version(version, wanted)


def test_an_extension_for_another_version_is_left_out_with_a_warning(caplog: pytest.LogCaptureFixture) -> None:
    class Newer(NodeActionExtension):
        EXTENSION_POINT_VERSION = '0.2'

    extensions: dict[str, NodeActionExtension] = {}
    assert instantiate_extension('g', 'newer', Newer, extensions, logging.getLogger('a')) is None
    assert "Failed to instantiate 'g' extension 'newer': Extension point is newer ('0.2')" in caplog.text
    assert extensions == {}

"""Which packages the commands of a notebook find."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.errors import UnusableInput

PACKAGE_XML = '<?xml version="1.0"?><package format="3"><name>mine</name><version>0.0.1</version></package>'


@pytest.fixture
def workspace(desk: Any) -> Any:
    desk.write('my_ws/src/mine/package.xml', PACKAGE_XML)
    return desk


def test_a_workspace_beside_the_notebook_is_found_by_itself(workspace: Any) -> None:
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws')]


def test_a_notebook_inside_a_workspace_finds_it_too(desk: Any) -> None:
    desk.write('src/mine/package.xml', PACKAGE_XML)
    assert desk.terminal.workspaces() == [str(desk.folder)]


@pytest.mark.parametrize(
    'word', ['my_ws', 'my_ws/', 'my_ws/install', 'my_ws/install/setup.bash', 'my_ws/install/local_setup.bash']
)
def test_sourcing_takes_what_a_shell_takes_without_a_build(workspace: Any, word: str) -> None:
    workspace.terminal.source(word)
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws')]


def test_an_install_folder_that_exists_is_used(workspace: Any) -> None:
    (workspace.folder / 'my_ws' / 'install').mkdir()
    workspace.terminal.source('my_ws/install/setup.bash')
    assert workspace.terminal.workspaces() == [str(workspace.folder / 'my_ws' / 'install')]


def test_a_folder_that_is_not_there_is_refused(desk: Any) -> None:
    with pytest.raises(UnusableInput, match="'my_wss': there is no such workspace"):
        desk.terminal.source('my_wss')

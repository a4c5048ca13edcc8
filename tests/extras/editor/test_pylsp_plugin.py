"""The plug-in of python-lsp-server, called as that server calls it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

pytest.importorskip('pylsp', reason='python-lsp-server is not installed: pip install python-lsp-server')

from edulaunch.extras.editor import pylsp_plugin  # noqa: E402


class Document:
    """What pylsp hands over."""

    def __init__(self, path: Path, source: str) -> None:
        self.uri, self.path, self.source = path.as_uri(), str(path), source


def at(path: Path, text: str) -> tuple[Any, dict[str, int]]:
    before, _, behind = text.partition('|')
    return Document(path, before + behind), {'line': before.count('\n'), 'character': len(before) - before.rfind('\n') - 1}


def test_a_mistake_is_marked(tmp_path: Path) -> None:
    document = Document(
        tmp_path / 'a.launch.py', 'from launch.actions import LogInof\n\n\ndef generate_launch_description():\n    return []\n'
    )
    (found,) = pylsp_plugin.pylsp_lint(None, None, document)
    assert (found['code'], found['range']['start']) == ('launch.import-name', {'line': 0, 'character': 27})


def test_other_python_files_belong_to_pylsp(tmp_path: Path) -> None:
    document, place = at(tmp_path / 'a.py', "print('|x')\n")
    assert pylsp_plugin.pylsp_lint(None, None, document) == []
    assert pylsp_plugin.pylsp_completions(None, None, document, place) == []


def test_completion_hover_definition_and_uses(tmp_path: Path) -> None:
    document, place = at(
        tmp_path / 'a.launch.py', "DeclareLaunchArgument('who', default_value='me')\nLaunchConfiguration('w|ho')\n"
    )
    assert [item['label'] for item in pylsp_plugin.pylsp_completions(None, None, document, place)] == ['who']
    shown = pylsp_plugin.pylsp_hover(None, None, document, place)
    assert shown is not None and 'default `me`' in shown['contents']['value']
    (target,) = pylsp_plugin.pylsp_definitions(None, None, document, place)
    assert target == {'uri': document.uri, 'range': {'start': {'line': 0, 'character': 23}, 'end': {'line': 0, 'character': 26}}}
    assert len(pylsp_plugin.pylsp_references(document, place)) == 2
    assert pylsp_plugin.pylsp_settings(None)['plugins']['edulaunch']['enabled']

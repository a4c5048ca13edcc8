"""The description for jupyter-lsp, and the files of the lab extension."""

from __future__ import annotations

import json

import pytest

from edulaunch.extras.editor import jupyter
from tests.house import ROOT

FOLDER = ROOT / 'edulaunch/extras/editor/labextension'


def test_the_server_is_announced_in_the_form_that_jupyter_lsp_asks_for() -> None:
    pytest.importorskip('pygls', reason="pygls is not installed: pip install 'edulaunch[editor]'")
    spec = jupyter.spec(None)['edulaunch']
    assert spec['argv'][1:] == ['-c', jupyter.START, 'lsp'] and spec['version'] == 2
    assert {'xml', 'yaml', jupyter.CELLS} <= set(spec['languages']) and not spec['requires_documents_on_disk']
    schema = pytest.importorskip('jupyter_lsp.schema')
    assert list(schema.LANGUAGE_SERVER_SPEC_MAP.iter_errors({'edulaunch': spec})) == []


def test_the_lab_extension_is_two_files_that_name_each_other() -> None:
    about = json.loads((FOLDER / 'package.json').read_text(encoding='utf-8'))
    script = (FOLDER / about['jupyterlab']['_build']['load']).read_text(encoding='utf-8')
    assert f"window._JUPYTERLAB['{about['name']}']" in script
    assert f"language: '{jupyter.CELLS}'" in script

"""The description of the language server for jupyter-lsp (entry point `jupyter_lsp_spec_v1`)."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from typing import Any

CELLS = 'launch-python'
"""The language of notebook cells that write a launch file, under the name of the lab extension."""
START = 'import sys; sys.path.pop(0); from edulaunch.desk.commands import edulaunch; sys.exit(edulaunch())'
"""Like `python -m edulaunch`, but without the current folder, so that a student's `json.py` is not imported."""


def spec(manager: Any) -> dict[str, Any]:
    """Return how JupyterLab starts the server, and for which languages. If pylsp is installed, it serves Python files instead."""
    if find_spec('pygls') is None:
        return {}
    languages = ['xml', 'yaml', CELLS, *([] if find_spec('pylsp') is not None else ['python'])]
    server = {
        'version': 2,
        'argv': [sys.executable, '-c', START, 'lsp'],
        'languages': languages,
        'mime_types': ['application/xml', 'text/xml', 'text/x-yaml', 'text/x-launch-python', 'text/x-python'],
        'display_name': 'edulaunch',
        'requires_documents_on_disk': False,
    }
    return {'edulaunch': server}

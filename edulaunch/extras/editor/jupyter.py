"""The language server, described for jupyter-lsp (entry point `jupyter_lsp_spec_v1`)."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from typing import Any

CELLS = 'launch-python'
"""The language of notebook cells that write a launch file, as the lab extension names it."""
START = 'import sys; sys.path.pop(0); from edulaunch.desk.commands import edulaunch; sys.exit(edulaunch())'
"""As `python -m edulaunch`, without the current folder: a student's `json.py` there must not be imported."""


def spec(manager: Any) -> dict[str, Any]:
    """How JupyterLab starts the server, and for which languages. Python files go to pylsp where it is installed."""
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

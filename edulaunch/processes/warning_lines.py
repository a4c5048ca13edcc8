"""Python's warnings: each stands on the stderr of the program whose code caused it."""
from __future__ import annotations

import warnings
from typing import Any, TextIO


def lead_warnings_to_programs() -> None:
    """From now on Python shows a warning where it belongs. Whoever collects warnings at this moment (pytest) goes on doing so."""
    collected = getattr(warnings._showwarnmsg_impl, '__module__', None) != 'warnings'  # type: ignore[attr-defined]
    if not collected and warnings.showwarning.__module__ == 'warnings':
        warnings.showwarning = show_warning


def show_warning(message: Warning | str, category: type[Warning], filename: str, lineno: int, file: TextIO | None = None,
                 line: str | None = None) -> None:
    """`warnings.showwarning` with the running program's stderr in the place of the interpreter's."""
    from edulaunch.processes.current import current_process
    target: Any = file or current_process().stderr
    target.write(warnings.formatwarning(message, category, filename, lineno, line))

"""The function that the shell command `edugrade` calls."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence

from edulaunch.runtime.quiet_start import run_quietly

NOT_GRADED = 3


def edugrade() -> int:
    """Run the command `edugrade`, and return its exit code. The code is 3 if this computer cannot load the command."""
    if not has_runs(sys.argv[1:]):
        return run_quietly('edugrade.cli', 'main', broken=NOT_GRADED)
    from .starter_link import end_early, start_early

    try:
        start_early()
        return run_quietly('edugrade.cli', 'main', broken=NOT_GRADED)
    finally:
        end_early()
        gc.freeze()  # this process ends now and has run nothing of a student, so its last collections can find nothing


def has_runs(words: Sequence[str]) -> bool:
    """Return whether a command line probably grades a file, on a system where each run has its own processes."""
    is_grading = words[:1] != [] and (words[0].startswith('-') or os.path.isfile(words[0]))
    return hasattr(os, 'fork') and sys.platform != 'emscripten' and is_grading and any(map(os.path.isfile, words))

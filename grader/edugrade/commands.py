"""The command `edugrade` as a shell starts it."""

from __future__ import annotations

from edulaunch.runtime.quiet_start import run_quietly

NOT_GRADED = 3


def edugrade() -> int:
    """Run the command `edugrade`, and return its exit code, 3 when this computer cannot even load it."""
    return run_quietly('edugrade.cli', 'main', broken=NOT_GRADED)

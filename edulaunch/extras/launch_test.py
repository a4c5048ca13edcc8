"""The installed command `launch_test`."""

from __future__ import annotations

from collections.abc import Sequence


def main(argv: Sequence[str] | None = None) -> int:
    """Run `launch_test FILE [name:=value ...]` of the package launch_testing, and return its exit code."""
    from edulaunch.ros.sourcing import source

    source()
    from edulaunch.extras.testing import launch_test

    return launch_test.main(argv)

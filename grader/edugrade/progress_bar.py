"""A progress bar on a terminal; silence elsewhere."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

WIDTH = 40


@contextmanager
def progress_bar(total: int) -> Iterator[Callable[[], None]]:
    """Gives a function to call after each of `total` runs. The bar goes to standard error, and away at the end."""
    if total == 0 or not sys.stderr.isatty():
        yield lambda: None
        return
    done = 0

    def show() -> None:
        filled = WIDTH * done // total
        sys.stderr.write(f'\r\x1b[Krunning the launch files [{"#" * filled}{"-" * (WIDTH - filled)}] {done}/{total}')
        sys.stderr.flush()

    def advance() -> None:
        nonlocal done
        done += 1
        show()

    show()
    try:
        yield advance
    finally:
        sys.stderr.write('\r\x1b[K')
        sys.stderr.flush()

"""The program linktime_composition: the same nodes, found by the name of their class."""

from __future__ import annotations

from composition._together import LIBRARIES, run_together


def main() -> None:
    """Talker, listener, server and client."""
    run_together(list(LIBRARIES.values()))


if __name__ == '__main__':
    main()

"""The program manual_composition: four nodes that its main function makes."""

from __future__ import annotations

from composition._together import LIBRARIES, run_together


def main() -> None:
    """Talker, listener, server and client."""
    run_together(list(LIBRARIES.values()))


if __name__ == '__main__':
    main()

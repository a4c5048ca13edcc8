"""The program talker: a numbered greeting on chatter every second."""

from __future__ import annotations

from demo_nodes_py._chatter import Talker
from demo_nodes_py._running import spin


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(Talker)


if __name__ == '__main__':
    main()

"""The program listener: logs what it hears on chatter."""

from __future__ import annotations

from demo_nodes_py._chatter import Listener
from demo_nodes_py._running import spin


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(Listener)


if __name__ == '__main__':
    main()

"""The program listener_qos: as listener, best effort unless told --reliable, for a number of messages."""

from __future__ import annotations

import sys

from demo_nodes_py._chatter import Listener
from demo_nodes_py._quality import run_with_quality


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    run_with_quality(sys.argv, 'listen', 'listener', Listener)


if __name__ == '__main__':
    main()

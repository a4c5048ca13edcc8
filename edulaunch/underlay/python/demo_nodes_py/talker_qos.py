"""The program talker_qos: as talker, best effort unless told --reliable, for a number of messages."""

from __future__ import annotations

import sys

from demo_nodes_py._chatter import Talker
from demo_nodes_py._quality import run_with_quality


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    run_with_quality(sys.argv, 'publish', 'talker', Talker)


if __name__ == '__main__':
    main()

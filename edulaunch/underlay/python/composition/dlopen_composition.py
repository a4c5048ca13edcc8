"""The program dlopen_composition: the nodes of the libraries that its command line names."""

from __future__ import annotations

import os
import sys

from rclpy.utilities import remove_ros_args

from composition._together import LIBRARIES, run_together


def main() -> None:
    """One node for each library, such as `$(ros2 pkg prefix composition)/lib/libtalker_component.so`."""
    words = remove_ros_args(sys.argv)[1:]
    if not words:
        sys.exit('Requires at least one argument to be passed with the library to load')
    unknown = [word for word in words if os.path.basename(word) not in LIBRARIES]
    if unknown:
        sys.exit(f'{unknown[0]} is not here; libraries of components: {", ".join(LIBRARIES)}')
    run_together([LIBRARIES[os.path.basename(word)] for word in words])


if __name__ == '__main__':
    main()

"""The `ros2` commands in the simulation, for launch files, notebooks and terminals: one file per verb.

`commands` lists them, `parser` reads a command line. The module of a verb (`topic/pub.py`) has
`add_arguments(parser)` and `main(arguments)`, which returns an exit code, None, or the text of its error.
Options, output and error texts are those of ROS 2 Jazzy; after an error there may be one line of help.
"""

from __future__ import annotations

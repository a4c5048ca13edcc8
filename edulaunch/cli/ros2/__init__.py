"""The `ros2` commands in the simulation, for launch files, notebooks and terminals: one file per command.

`commands` lists and loads them, `parser` reads a command line. For each verb the file of a command (`service.py`) has
`VERB_arguments(parser)` and `VERB_verb(arguments)`, which returns an exit code, None, or the text of its error; large ones have a
file of their own (`topic_pub.py`: `add_arguments`, `main`).
Options, output and error texts are those of ROS 2 Jazzy; after an error there may be one line of help.
"""

from __future__ import annotations

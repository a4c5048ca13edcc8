"""The `ros2` commands in the simulation, for launch files, notebooks and terminals: one file per command.

`commands` lists, reads and loads them. For each verb the file of a command (`service.py`) has `VERB_arguments(parser)` and
`VERB_verb(arguments)`, which returns an exit code, None, or the text of its error. What verbs share: `cli_node` (a node and
waiting), `output` (lines and names), `fill_message` (types and values that are given), `listening` (printing what comes).
Options, output and error texts are those of ROS 2 Jazzy; after an error there may be one line of help.
"""

from __future__ import annotations

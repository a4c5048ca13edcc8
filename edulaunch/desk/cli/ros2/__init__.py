"""The `ros2` commands in the simulation, for launch files, notebooks and terminals: one file per command.

`commands` lists, reads and loads the commands. For each verb, the file of a command (`service.py`) has `VERB_arguments(parser)`
and `VERB_verb(arguments)`, which returns an exit code, None, or an error message. Verbs share `cli_node` (a node and waiting),
`output` (lines and names), `fill_message` (types and values from the command line), and `listening` (printing messages).
Options, output and error messages are those of ROS 2 Jazzy; one line of help may follow an error.
"""

from __future__ import annotations

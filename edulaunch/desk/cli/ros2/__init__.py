"""The `ros2` commands in the simulation, for launch files, notebooks and terminals. Each command has its own file.

`commands` lists the commands, parses a command line and loads the command. For each verb, the file of a command (such as
`service.py`) defines `VERB_arguments(parser)` and `VERB_verb(arguments)`. A verb function returns an exit code, None, or an
error message. The verbs share four modules:

- `cli_node` creates a node, and waits in simulated time.
- `output` prints lines, and reads numbers from the command line.
- `fill_message` finds the class of a type, and fills a message with values from the command line.
- `listening` prints the messages of a topic.

Options, output and error messages are those of ROS 2 Jazzy. One line of help may follow an error message.
"""

from __future__ import annotations

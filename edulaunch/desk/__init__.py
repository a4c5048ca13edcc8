"""The user interface: the commands, the shared machine and the live view.

`cli/` has the commands `edulaunch` and `ros2`, one file for each verb.
`machine/` is the simulated machine that terminals and notebooks share: a server, its clients, and the connection between them.
`view/` is the live view: the page that shows turtles, frames, graph and numbers of a run.
It may import every wing but `extras`, `jupyter` and `course`; start reading with `cli/main.py` and `machine/server.py`.
"""

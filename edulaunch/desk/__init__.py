"""The user interface: the commands, the shared machine, the live view and the notebook.

`cli/` has the commands `edulaunch` and `ros2`, one file for each verb.
`machine/` is the simulated machine that terminals and notebooks share: a server, its clients, and the connection between them.
`view/` is the live view: the page that shows turtles, frames, graph and numbers of a run. `notebook/` has the magics.
`facade.py` is what `import edulaunch` offers.
It may import every wing except `extras`, `course` and the grader; start reading with `cli/main.py` and `machine/server.py`.
An import is inside a function only if most uses of the module do not need it.
"""

"""The user interface: the commands, the shared machine, the live view and the notebook.

- `cli/` contains the commands `edulaunch` and `ros2`, with one file for each verb.
- `machine/` contains the simulated machine that terminals and notebooks share: a server, its clients, and their connection.
- `view/` contains the live view, a page that shows turtles, frames, the graph and numbers of a run.
- `notebook/` contains the magics.
- `facade.py` defines the public names of `import edulaunch`.

This package may import everything except `extras`, `course` and the grader. Start reading with `cli/main.py` and
`machine/server.py`. An import is inside a function only if most uses of the module do not need it.
"""

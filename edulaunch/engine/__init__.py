"""The engine: the simulated computer on which launch files and nodes run.

It owns simulated time (`sim`), message classes (`interfaces`), topics, services and parameters (`graph`), transforms (`tf`),
turtles and robots as numbers (`worlds`), installed packages (`packages`), programs (`processes`) and what a run leaves
behind (`recording`).
It imports the standard library, PyYAML, greenlet and `edulaunch.errors`, and no other wing.
It knows no ROS package, no shell, no build tool and no network; other wings give it these when they start it.
Start reading with `sim/simulation.py`, then `sim/task.py`; `docs/engine.md` has the whole way in an hour.
"""

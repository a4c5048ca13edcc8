"""The engine: the simulated machine on which launch files and nodes run.

It contains simulated time (`sim`), message classes (`interfaces`), and topics, services and parameters (`graph`). It also
contains transforms (`tf`), turtles and robots as numbers (`worlds`), installed packages (`packages`), programs (`processes`)
and recordings (`recording`). It imports the standard library, PyYAML, greenlet and `edulaunch.errors`, and no other wing. It
knows no ROS package, no shell, no build tool and no network; other wings pass these in. Start reading with
`sim/simulation.py`, then `sim/task.py`; `docs/engine.md` is a tour that takes an hour.
An import is inside a function only if most uses of the module do not need it.
"""

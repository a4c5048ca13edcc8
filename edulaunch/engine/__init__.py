"""The engine: the simulated machine on which launch files and nodes run.

The engine contains simulated time (`sim`), message classes (`interfaces`), and topics, services and parameters (`graph`). It
also contains transforms (`tf`), the motion of turtles and robots (`worlds`), installed packages (`packages`), programs
(`processes`) and recordings (`recording`).

The engine imports only the standard library, PyYAML, greenlet and `edulaunch.errors`. It does not depend on ROS packages, a
shell, build tools or a network: other parts of edulaunch pass these in. Start reading with `sim/simulation.py`, then
`sim/task.py`; `docs/engine.md` is a tour that takes an hour. An import is inside a function only if most uses of the module
do not need it.
"""

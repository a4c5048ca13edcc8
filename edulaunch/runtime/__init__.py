"""The runtime: the only top-level part of edulaunch that combines the engine and ROS's packages, and runs a launch file.

`session.py` creates a simulation with its recorder and starts `ros2 launch` in it. `launching.py` and `launch_process.py`
implement this `ros2 launch`. `link/` runs one simulation in two operating-system processes, a trusted process and a confined
process, and records the same as in one process. The runtime imports the engine and ROS's packages. It does not import
pictures, advice and commands, which depend on it. Start reading with `session.py`. An import is inside a function only if
most uses of the module do not need it.
"""

"""The runtime: the only wing that combines the engine and ROS's packages, and runs a launch file.

`session.py` creates a simulation with its recorder and starts `ros2 launch` in it. `launching.py` and `launch_process.py` are
that program.
`link/` runs one simulation in two operating-system processes, a trusted one and a confined one, with the same recording.
It imports the engine and ROS's packages. Pictures, advice and commands are above it, and it does not import them.
Start reading with `session.py`.
An import is inside a function only if most uses of the module do not need it.
"""

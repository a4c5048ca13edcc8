"""ROS's own packages under ROS's own names: `launch`, `rclpy`, `tf2_ros`, `turtlesim`, the message packages and their data.

The folder has the layout of an install prefix. `python/` contains the import packages. `share/` contains their launch files,
interfaces and `package.xml`. `programs/` contains programs in the style of students' programs. A package here wraps
`edulaunch.engine` with ROS 2's names, defaults and error messages, and may import only the engine. `sources/` reads the
build files of source packages, and `serialization/` converts messages to bytes and text. An installation adds no top-level
name for these packages: `edulaunch.source()` (in `sourcing.py`) puts `python/` on the path. An import is inside a function
only if most uses of the module do not need it. A program with launch and rclpy loads 129 of their 281 modules. Loading all
of them would take 0.25 s instead of 0.10 s. Start reading with `python/rclpy/node.py` and `python/launch/launch_service.py`.
"""

"""ROS's own packages at ROS's own names: `launch`, `rclpy`, `tf2_ros`, `turtlesim`, the message packages and their data.

The folder is laid out like an install prefix: `python/` has the import packages, `share/` their launch files, interfaces and
`package.xml`, `programs/` the programs that are written as students write theirs.
A package here is a face over `edulaunch.engine`, with ROS 2's names, defaults and error texts; it may import the engine only.
`sources/` reads the build files of source packages, and `serialization/` has messages as bytes and text.
Nothing here is a top-level name of an installation: `edulaunch.source()` (in `sourcing.py`) puts `python/` on the path.
An import stands inside a function only where it loads what the module does without until then: a program with launch and rclpy
loads 129 of their 281 modules, and all of them would take 0.25 s instead of 0.10 s.
Start reading with `python/rclpy/node.py` and `python/launch/launch_service.py`.
"""

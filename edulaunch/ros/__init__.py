"""ROS's own packages at ROS's own names: `launch`, `rclpy`, `tf2_ros`, `turtlesim`, the message packages and their data.

The folder has the layout of an install prefix. `python/` has the import packages, and `share/` their launch files, interfaces and
`package.xml`. `programs/` has programs that are written as students write theirs. A package here wraps `edulaunch.engine` with
ROS 2's names, defaults and error messages, and may import only the engine. `sources/` reads the build files of source packages,
and `serialization/` has messages as bytes and text. Nothing here is a top-level name of an installation: `edulaunch.source()` (in
`sourcing.py`) puts `python/` on the path. An import is inside a function only if most uses of the module do not need it. A
program with launch and rclpy loads 129 of their 281 modules, and all of them would take 0.25 s instead of 0.10 s. Start reading
with `python/rclpy/node.py` and `python/launch/launch_service.py`.
"""

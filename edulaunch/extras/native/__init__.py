"""Programs on the real rclpy: its environment, type support for all of edulaunch's messages, and launches of real processes.

`environment` installs and finds the wheels of the real rclpy. With `typesupport`, the real rclpy can use message classes that are
generated from .msg files.
`program` runs in each real process, with `adapter` in place of the engine. `host` starts such processes for launch.
Inside the environment, only `typesupport`, `program` and `adapter` are imported.
"""

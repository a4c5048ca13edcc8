"""Programs on the real rclpy: its environment, type support for all our messages, and launches of real processes.

`environment` installs and finds the wheels of the real rclpy. `typesupport` lets that rclpy use message classes made from text.
`program` runs in each real process, with `adapter` in place of the engine. `host` starts such processes for launch.
Inside the environment, only `typesupport`, `program` and `adapter` are imported.
"""

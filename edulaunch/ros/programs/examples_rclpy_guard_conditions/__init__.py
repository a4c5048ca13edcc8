"""examples_rclpy_guard_conditions: A guard condition: a callback that the program itself calls for."""

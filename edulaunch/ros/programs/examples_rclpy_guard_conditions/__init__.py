"""examples_rclpy_guard_conditions: A guard condition, which is a callback that the program itself triggers."""

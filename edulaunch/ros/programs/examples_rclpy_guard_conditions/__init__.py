"""examples_rclpy_guard_conditions: A guard condition, whose callback the program itself triggers."""

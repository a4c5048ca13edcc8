"""examples_rclpy_executors: Several nodes in one program, and custom executors and callback groups."""

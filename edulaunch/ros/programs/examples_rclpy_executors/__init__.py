"""examples_rclpy_executors: Several nodes in one program, and executors of its own."""

"""examples_rclpy_minimal_publisher: One publisher, written in three ways."""

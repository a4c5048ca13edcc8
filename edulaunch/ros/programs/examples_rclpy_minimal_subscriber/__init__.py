"""examples_rclpy_minimal_subscriber: The same subscriber written in three ways."""

"""examples_rclpy_minimal_publisher: The same publisher written in three ways."""

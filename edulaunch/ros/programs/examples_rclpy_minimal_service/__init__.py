"""examples_rclpy_minimal_service: A service that adds, written in two ways."""

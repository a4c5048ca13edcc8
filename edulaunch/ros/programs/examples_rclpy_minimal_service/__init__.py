"""examples_rclpy_minimal_service: A service that adds two numbers, written in two ways."""

"""examples_rclpy_minimal_client: A client that requests the sum 41 + 1, written in four ways."""

"""examples_rclpy_minimal_client: A client that asks for 41 + 1, written in four ways."""

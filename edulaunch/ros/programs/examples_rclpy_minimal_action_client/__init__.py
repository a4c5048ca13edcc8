"""examples_rclpy_minimal_action_client: An action client that asks for ten Fibonacci numbers, written in four ways."""

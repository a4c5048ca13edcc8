"""examples_rclpy_minimal_action_client: An action client that requests ten Fibonacci numbers, written in four ways."""

"""examples_rclpy_minimal_action_server: An action server that computes Fibonacci numbers, with five ways to treat goals."""

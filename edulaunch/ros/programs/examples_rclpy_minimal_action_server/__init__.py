"""examples_rclpy_minimal_action_server: An action server that counts Fibonacci numbers, which treats goals in five ways."""

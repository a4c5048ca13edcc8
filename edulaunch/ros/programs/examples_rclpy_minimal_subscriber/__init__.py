"""examples_rclpy_minimal_subscriber: One subscriber, written in three ways."""
